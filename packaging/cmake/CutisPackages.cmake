# What is installed, and the Debian packages of it: cutis-cli, the command line without Qt Widgets,
# and cutis, the editor. Neither needs the other, and no file is in both.
#
#   cmake --install build/release --component cli --prefix FOLDER
#   cpack --config build/release/CPackConfig.cmake
#
# Nothing runs when a package is installed or removed: the triggers of Debian's own packages follow
# the folders of icons, desktop entries and MIME types.

set(CUTIS_MAINTAINER "The Cutis authors <authors@cutis.invalid>" CACHE STRING
    "Who builds the packages, with an address for their users")

install(TARGETS cutis-cli DESTINATION bin COMPONENT cli)
# Where moduleSymbol() of src/files/system/platform.h looks for it. One folder higher, CPack would take it
# for a library for all and run ldconfig.
install(TARGETS cutis_rasteriser DESTINATION lib/cutis/modules COMPONENT cli)
install(FILES LICENSE NOTICE packaging/debian/copyright DESTINATION share/doc/cutis-cli COMPONENT cli)

install(TARGETS cutis DESTINATION bin COMPONENT editor)
install(FILES LICENSE NOTICE packaging/debian/copyright DESTINATION share/doc/cutis COMPONENT editor)
install(FILES packaging/desktop/cutis.desktop DESTINATION share/applications COMPONENT editor)
install(FILES packaging/desktop/cutis.metainfo.xml DESTINATION share/metainfo COMPONENT editor)
install(FILES packaging/desktop/cutis-mime.xml DESTINATION share/mime/packages
        RENAME cutis.xml COMPONENT editor)
install(FILES resources/icons/cutis.svg DESTINATION share/icons/hicolor/scalable/apps
        COMPONENT editor)
foreach(size IN ITEMS 16 32 64 256)
  install(FILES resources/icons/cutis-${size}.png
          DESTINATION share/icons/hicolor/${size}x${size}/apps
          RENAME cutis.png COMPONENT editor)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Cutis authors")
set(CPACK_PACKAGE_CONTACT "${CUTIS_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Whatever the umask of whoever builds the packages.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL cli editor)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
# Each package has a first line of its own instead of the project's.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_CLI_PACKAGE_NAME cutis-cli)
set(CPACK_DEBIAN_CLI_DESCRIPTION "chromophores of human skin from photographs (command line)
Takes photographs of human skin under known lights, or an albedo texture,
apart into maps of melanin, blood and carotene, edits them, and gives back the
edited albedo or the same skin under another light.")

set(CPACK_DEBIAN_EDITOR_PACKAGE_NAME cutis)
set(CPACK_DEBIAN_EDITOR_PACKAGE_RECOMMENDS "qt6-wayland")
set(CPACK_DEBIAN_EDITOR_PACKAGE_SUGGESTS "cutis-cli")
set(CPACK_DEBIAN_EDITOR_DESCRIPTION "editor for human skin: from photographs to chromophores and back
Takes photographs of human skin under known lights, or an albedo texture,
apart into maps of melanin, blood and carotene, lets them be edited, and gives
back the edited albedo or the same skin under another light.")
include(CPack)
