# Rust, Julia and Python, ends of handles under valgrind, and the examples, which print the same in
# every language.

# -------------------------------------------------------------------- Rust

find_program(CARGO cargo REQUIRED)
set(rust_environment
    "AMST_LIB_DIR=$<TARGET_FILE_DIR:alphamst>"
    "CARGO_TARGET_DIR=${CMAKE_CURRENT_BINARY_DIR}/rust")
function(add_rust_test name)
    add_test(NAME rust.${name} COMMAND "${CARGO}" ${ARGN}
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/bindings/rust")
    set_tests_properties(rust.${name} PROPERTIES
        LABELS rust ENVIRONMENT "${rust_environment}" RESOURCE_LOCK rust TIMEOUT 900)
endfunction()
add_rust_test(build build --locked --all-targets)
set_tests_properties(rust.build PROPERTIES FIXTURES_SETUP rust)
add_rust_test(test test --locked --tests)
add_rust_test(documentation test --locked --doc)
add_rust_test(clippy clippy --locked --all-targets -- -D warnings)
add_rust_test(format fmt --check)
set_tests_properties(rust.test rust.documentation PROPERTIES FIXTURES_REQUIRED rust)

# ------------------------------------------- every order of ends, no error

find_program(VALGRIND valgrind REQUIRED)
set(watched "${VALGRIND}" --quiet --leak-check=full --errors-for-leak-kinds=definite --error-exitcode=9)
add_test(NAME fortran.lifetime.valgrind COMMAND ${watched} $<TARGET_FILE:fortran_lifetime>)
set_tests_properties(fortran.lifetime.valgrind PROPERTIES LABELS fortran TIMEOUT 600)
add_rust_test(destroy.valgrind test --locked --test destroy)
list(JOIN watched " " watched)
set_tests_properties(rust.destroy.valgrind PROPERTIES FIXTURES_REQUIRED rust
    ENVIRONMENT "${rust_environment};CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_RUNNER=${watched};CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER=${watched}")

# ------------------------------------------------------------------- Julia

find_program(JULIA julia REQUIRED)
set(julia_environment
    "AMST_LIBRARY=$<TARGET_FILE:alphamst>"
    "JULIA_DEPOT_PATH=${CMAKE_CURRENT_BINARY_DIR}/julia")
set(julia_project "--project=${PROJECT_SOURCE_DIR}/bindings/julia")
add_test(NAME julia.test COMMAND "${JULIA}" --startup-file=no ${julia_project}
    "${PROJECT_SOURCE_DIR}/bindings/julia/test/runtests.jl")
set_tests_properties(julia.test PROPERTIES
    LABELS julia ENVIRONMENT "${julia_environment}" RESOURCE_LOCK julia TIMEOUT 900)

# ------------------------------------------------------------------ Python

# The package that the build has made, with the Python that it was made for.
set(python_environment "PYTHONPATH=${PROJECT_BINARY_DIR}/bindings/python" "PYTHONDONTWRITEBYTECODE=1")
add_test(NAME python.test
    COMMAND "${PYTHON}" -W error -m unittest discover -s "${PROJECT_SOURCE_DIR}/bindings/python/test" -p "*_test.py")
set_tests_properties(python.test PROPERTIES LABELS python ENVIRONMENT "${python_environment}" TIMEOUT 300)

# --------------------------------------------------- projects of other people

foreach(language rust julia)
    add_test(NAME consumer.${language}
        COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/consumer/${language}.sh"
            "${prefix}" "${PROJECT_SOURCE_DIR}/bindings/${language}" "${CMAKE_CURRENT_BINARY_DIR}/consumer.${language}")
    set_tests_properties(consumer.${language} PROPERTIES LABELS consumer FIXTURES_REQUIRED installed TIMEOUT 300)
endforeach()

# ---------------------------------------------------------------- examples

set(small "${PROJECT_SOURCE_DIR}/examples/data/coast_small.msh")
set(plate "${PROJECT_SOURCE_DIR}/examples/data/plate.off")
function(add_example_test language name)
    add_test(NAME example.${language}.${name}
        COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/example/same.sh" $<TARGET_FILE:example_${name}> "${input}" ${ARGN})
    set_tests_properties(example.${language}.${name} PROPERTIES LABELS example TIMEOUT 300)
endfunction()
foreach(name improve front simplify sizes corners undo chords surface wall wave)
    set(input "${small}")
    if(name STREQUAL chords)
        set(input "${plate}")
    elseif(name STREQUAL surface)
        set(input 0.5)
    elseif(name STREQUAL wall)
        set(input 4)
    elseif(name STREQUAL wave)
        set(input 6)
    endif()
    add_test(NAME example.c.${name} COMMAND example_${name} "${input}")
    set_tests_properties(example.c.${name} PROPERTIES LABELS example TIMEOUT 300)
    add_example_test(fortran ${name} $<TARGET_FILE:example_fortran_${name}>)
    add_example_test(rust ${name} "${CMAKE_CURRENT_BINARY_DIR}/rust/debug/examples/${name}")
    set_tests_properties(example.rust.${name} PROPERTIES FIXTURES_REQUIRED rust
        ENVIRONMENT "LD_LIBRARY_PATH=$<TARGET_FILE_DIR:alphamst>")
    add_example_test(julia ${name}
        "${JULIA}" --startup-file=no ${julia_project} "${PROJECT_SOURCE_DIR}/examples/julia/${name}.jl")
    set_tests_properties(example.julia.${name} PROPERTIES ENVIRONMENT "${julia_environment}" RESOURCE_LOCK julia)
    add_example_test(python ${name} "${PYTHON}" "${PROJECT_SOURCE_DIR}/examples/python/${name}.py")
    set_tests_properties(example.python.${name} PROPERTIES ENVIRONMENT "${python_environment}")
endforeach()
# Stops by itself if mass, momentum or energy are lost where the mesh changes.
add_test(NAME example.fortran.euler COMMAND example_fortran_euler 20)
set_tests_properties(example.fortran.euler PROPERTIES LABELS example TIMEOUT 300)
