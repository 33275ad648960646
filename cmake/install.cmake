# Where everything lies: the build tree has the installation's folders, so that a program finds its scenarios in both by
# the same relative path, and an installation may be moved. Components: library, development, program, python.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(SUDAR_SCENARIO_FOLDER ${CMAKE_INSTALL_LIBDIR}/sudar/scenarios)
set(SUDAR_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/sudar)

# sudar_relative(VARIABLE FROM TO): the way between two folders of the installation.
function(sudar_relative variable from to)
  file(RELATIVE_PATH path /${from} /${to})
  set(${variable} ${path} PARENT_SCOPE)
endfunction()
sudar_relative(SUDAR_SCENARIOS_FROM_PROGRAM ${CMAKE_INSTALL_BINDIR} ${SUDAR_SCENARIO_FOLDER})
sudar_relative(SUDAR_LIBRARY_FROM_PROGRAM ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_LIBDIR})
sudar_relative(SUDAR_LIBRARY_FROM_SCENARIOS ${SUDAR_SCENARIO_FOLDER} ${CMAKE_INSTALL_LIBDIR})

# sudar_install_library(): to be called once the target sudar is complete.
function(sudar_install_library)
  # Until 1.0 a minor version may break what was linked with the one before.
  set_target_properties(sudar PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set_target_properties(sudar_numerics PROPERTIES EXPORT_NAME numerics)
  install(TARGETS sudar sudar_numerics EXPORT sudar
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/sudar DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  install(EXPORT sudar NAMESPACE sudar:: FILE sudar-targets.cmake DESTINATION ${SUDAR_PACKAGE_FOLDER}
    COMPONENT development)

  configure_package_config_file(cmake/sudar-config.cmake.in ${PROJECT_BINARY_DIR}/sudar-config.cmake
    INSTALL_DESTINATION ${SUDAR_PACKAGE_FOLDER} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/sudar-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/sudar-config.cmake ${PROJECT_BINARY_DIR}/sudar-config-version.cmake
    cmake/sudar_scenario.cmake DESTINATION ${SUDAR_PACKAGE_FOLDER} COMPONENT development)

  sudar_install_pc(sudar)
endfunction()

# sudar_install_pc(NAME): cmake/NAME.pc.in for pkg-config.
function(sudar_install_pc name)
  sudar_relative(SUDAR_PREFIX_FROM_PC ${CMAKE_INSTALL_LIBDIR}/pkgconfig .)
  if(SUDAR_DOUBLE)
    set(SUDAR_PC_FLAGS " -DSUDAR_DOUBLE")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
