# In place of Zephyr's own package: the target app, the modules, and of its functions those that modules use.
project(Zephyr-Kernel LANGUAGES C)
add_library(zephyr_interface INTERFACE)
add_executable(app)
target_link_libraries(app PRIVATE zephyr_interface)

function(zephyr_include_directories)
    target_include_directories(zephyr_interface INTERFACE ${ARGV})
endfunction()

macro(zephyr_library_named name)
    set(ZEPHYR_CURRENT_LIBRARY ${name})
    add_library(${name} STATIC "")
    target_link_libraries(${name} PUBLIC zephyr_interface)
    target_link_libraries(app PRIVATE ${name} m)
endmacro()

function(zephyr_library_sources)
    target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGV})
endfunction()

function(zephyr_library_compile_options)
    target_compile_options(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGV})
endfunction()

foreach(module IN LISTS ZEPHYR_EXTRA_MODULES)
    execute_process(
        COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/configure.py" "${module}" "${CMAKE_CURRENT_SOURCE_DIR}/prj.conf"
        OUTPUT_FILE "${CMAKE_BINARY_DIR}/configuration.cmake"
        COMMAND_ERROR_IS_FATAL ANY)
    include("${CMAKE_BINARY_DIR}/configuration.cmake")
    add_subdirectory("${module_cmake}" "${CMAKE_BINARY_DIR}/modules/${module_name}")
endforeach()
