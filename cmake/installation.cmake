# SPDX-License-Identifier: BSD-3-Clause
# find_package(trivet) gives trivet::LAYER for every layer.
include(CMakePackageConfigHelpers)
get_property(layers GLOBAL PROPERTY TRIVET_LAYERS)
list(TRANSFORM layers PREPEND trivet_ OUTPUT_VARIABLE layer_targets)
install(TARGETS ${layer_targets} EXPORT trivet FILE_SET HEADERS)
install(TARGETS trivet_cli)
set(shell_files ${PROJECT_BINARY_DIR}/apps/cli/shell)
install(FILES ${shell_files}/trivet.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${shell_files}/trivet DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${shell_files}/_trivet DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${shell_files}/trivet.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${PROJECT_SOURCE_DIR}/catalogues/generic.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/trivet/catalogues)
install(FILES ${PROJECT_SOURCE_DIR}/web/dist/licences.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/trivet/licences RENAME page)  # of trivet serve and of reports
install(EXPORT trivet NAMESPACE trivet:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/trivet FILE trivet-targets.cmake)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/trivet-config.cmake.in
  ${PROJECT_BINARY_DIR}/trivet-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/trivet)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trivet-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/trivet-config.cmake ${PROJECT_BINARY_DIR}/trivet-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/trivet)
if(TRIVET_PORTABLE)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/static_libraries.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/trivet)
endif()
