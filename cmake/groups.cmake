# Compiles the sources of a target several at a time. Most of what compiling a source takes goes into
# templates of its headers, and the sources of a folder share them.
#
# Sources of one group see each other's unnamed namespaces. Two go together only if neither has a word,
# comments and strings left out, that the other defines there, so that none means something else than
# when it is compiled alone. What is overlooked is an error of the compiler: rename one of the two.

set(ALPHAMST_GROUP 8) # sources at most: as a whole they are compiled anew when one changes

# Sets <source>_words to the words of a source, between semicolons, and <source>_defined to a regular
# expression for those that its unnamed namespaces define at the beginning of a line.
function(alphamst_read_words source)
    file(READ "${source}" text)
    string(REGEX REPLACE "[][;]" "@" text "${text}") # they would make or hide elements of lists
    string(REGEX MATCH "\nnamespace {\n.*\n} // namespace\n" unnamed "${text}")
    foreach(part text unnamed)
        string(REGEX REPLACE "//[^\n]*|\"[^\"\n]*\"" "" ${part} "${${part}}")
    endforeach()
    string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]*" words "${text}")
    list(REMOVE_DUPLICATES words)
    set("${source}_words" ";${words};" PARENT_SCOPE)

    string(REGEX MATCHALL "\n[A-Za-z][^\n]*" lines "${unnamed}")
    string(REGEX REPLACE "([A-Za-z_0-9]+::)+[A-Za-z_0-9]+" "" lines "${lines}")
    string(REGEX MATCHALL "operator|[A-Za-z_][A-Za-z_0-9]* *[({=:@]" defined "${lines}")
    list(TRANSFORM defined REPLACE " *[({=:@]$" "")
    list(REMOVE_DUPLICATES defined)
    list(REMOVE_ITEM defined namespace using public protected private return void TEST TEST_F TEST_P)
    list(JOIN defined "|" defined)
    set("${source}_defined" "${defined}" PARENT_SCOPE)
endfunction()

function(alphamst_compile_in_groups target)
    if(NOT ALPHAMST_GROUPS)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    set(groups 0)
    foreach(source ${sources})
        get_filename_component(source "${source}" ABSOLUTE)
        alphamst_read_words("${source}")
        get_filename_component(folder "${source}" DIRECTORY)
        set(place -1)
        set(group 0)
        while(place EQUAL -1 AND group LESS groups)
            list(LENGTH group_${group} length)
            if(folder STREQUAL folder_${group} AND length LESS ALPHAMST_GROUP)
                set(place ${group})
                foreach(other ${group_${group}})
                    if("${${source}_words}" MATCHES ";(${${other}_defined});"
                            OR "${${other}_words}" MATCHES ";(${${source}_defined});")
                        set(place -1)
                        break()
                    endif()
                endforeach()
            endif()
            math(EXPR group "${group} + 1")
        endwhile()
        if(place EQUAL -1)
            set(place ${groups})
            set(folder_${place} "${folder}")
            math(EXPR groups "${groups} + 1")
        endif()
        list(APPEND group_${place} "${source}")
        # A source that was changed may have to change its group.
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    endforeach()
    foreach(group RANGE ${groups})
        list(LENGTH group_${group} length)
        if(length GREATER 1)
            set_source_files_properties(${group_${group}} PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # Types of an unnamed namespace are as good in a source that a group includes as they are in any source.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>) # Clang does not warn
endfunction()
