# cpack -G DEB: wetdeck (the program, its scenes, data, manual, completion) and libwetdeck-dev (libraries and headers).
# CPack needs the packages file and dpkg-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "wetdeck developers <wetdeck@example.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "SPH of bodies that slam into water, checked against experiments")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME wetdeck)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")  # static figures of the report
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, slurm-client, bash-completion")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Runs published water-impact experiments by smoothed particle hydrodynamics and writes
one report that says what was reached, what was not, and at what cost.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwetdeck-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "wetdeck, libhdf5-dev, libgsl-dev, libudunits2-dev, libvtk9-dev, libfmt-dev, nlohmann-json3-dev, libtomlplusplus-dev, libmuparser-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Static libraries and headers for find_package(wetdeck).")
include(CPack)
