# The rules of the house, see house/check.py. What they look at is the same for every build,
# so the builds with sanitizers leave them out.
if(NOT ALPHAMST_SANITIZE)
    find_program(CLANG_FORMAT clang-format REQUIRED)
    find_program(CLANG_TIDY clang-tidy REQUIRED)
    function(add_house_test name timeout)
        add_test(NAME house.${name}
            COMMAND Python3::Interpreter -B ${ARGN}
            WORKING_DIRECTORY "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
        set_tests_properties(house.${name} PROPERTIES LABELS house TIMEOUT ${timeout})
    endfunction()
    foreach(rule includes names lengths tests format)
        add_house_test(${rule} 60 check.py ${rule})
    endforeach()
    # Reading every source takes many minutes; see check.py for what is read otherwise.
    set(all)
    set(timeout 600)
    if(ALPHAMST_FULL_CAMPAIGN)
        set(all --full)
        set(timeout 7200)
    endif()
    add_house_test(tidy ${timeout} check.py tidy --build "${PROJECT_BINARY_DIR}" ${all})
    add_house_test(mistakes 300 check_test.py)
    # It uses all processors by itself, and is among the longest.
    set_tests_properties(house.tidy PROPERTIES COST 90)
endif()
