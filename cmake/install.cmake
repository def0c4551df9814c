# What an installed AlphaMST consists of. Components: alphamst_Runtime, what programs need to run, and
# alphamst_Development, what is needed to build them.
list(TRANSFORM ALPHAMST_RUNTIME PREPEND -l)
list(JOIN ALPHAMST_RUNTIME " " ALPHAMST_RUNTIME)
set(ALPHAMST_PRIVATE_LIBS "-lOpenMeshCore -ltbb -lexpat -lz ${ALPHAMST_RUNTIME} -pthread")
# A prefix with the static library alone has one way to link.
set(ALPHAMST_PC_CFLAGS "")
set(ALPHAMST_PC_LIBS "")
if(NOT "shared" IN_LIST ALPHAMST_LINKAGES)
    set(ALPHAMST_PC_CFLAGS " -DAMST_STATIC")
    set(ALPHAMST_PC_LIBS " ${ALPHAMST_PRIVATE_LIBS}")
endif()

set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/alphamst")
set(pkgconfig_directory "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH ALPHAMST_PC_TO_PREFIX
    "${CMAKE_INSTALL_PREFIX}/${pkgconfig_directory}" "${CMAKE_INSTALL_PREFIX}")
configure_file(cmake/alphamst.pc.in alphamst.pc @ONLY)
configure_package_config_file(cmake/alphamst-config.cmake.in alphamst-config.cmake
    INSTALL_DESTINATION "${package_directory}")
write_basic_package_version_file(alphamst-config-version.cmake COMPATIBILITY SameMinorVersion)

foreach(linkage ${ALPHAMST_LINKAGES})
    install(TARGETS ${alphamst_${linkage}_target} EXPORT alphamst-${linkage}
        RUNTIME COMPONENT alphamst_Runtime
        LIBRARY COMPONENT alphamst_Runtime NAMELINK_COMPONENT alphamst_Development
        ARCHIVE COMPONENT alphamst_Development
        FILE_SET HEADERS COMPONENT alphamst_Development)
    install(EXPORT alphamst-${linkage} FILE alphamst-${linkage}.cmake NAMESPACE alphamst::
        DESTINATION "${package_directory}" COMPONENT alphamst_Development)
endforeach()
install(FILES
    "${PROJECT_BINARY_DIR}/alphamst-config.cmake"
    "${PROJECT_BINARY_DIR}/alphamst-config-version.cmake"
    DESTINATION "${package_directory}" COMPONENT alphamst_Development)
install(FILES "${PROJECT_BINARY_DIR}/alphamst.pc"
    DESTINATION "${pkgconfig_directory}" COMPONENT alphamst_Development)
