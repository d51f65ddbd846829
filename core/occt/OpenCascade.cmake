# OpenCASCADE's modelling and data exchange libraries as the imported target osculate::opencascade,
# for the build and for programs that use the installed package. Found by file, because the targets
# of find_package(OpenCASCADE) name libtbb, which the development packages of OpenCASCADE do not
# bring. The names are those of OpenCASCADE 7.6 to 7.9; 7.8 renamed the readers (TKSTEP to TKDESTEP,
# TKIGES to TKDEIGES).
if(NOT TARGET osculate::opencascade)
  find_path(OSCULATE_OPENCASCADE_INCLUDE_DIR Standard_Version.hxx
    PATH_SUFFIXES opencascade occt REQUIRED)
  add_library(osculate::opencascade INTERFACE IMPORTED GLOBAL)
  target_include_directories(osculate::opencascade INTERFACE ${OSCULATE_OPENCASCADE_INCLUDE_DIR})
  foreach(names "TKDESTEP;TKSTEP" "TKDEIGES;TKIGES" TKXSBase TKTopAlgo TKGeomAlgo TKBRep TKGeomBase
      TKG3d TKG2d TKMath TKernel)
    list(GET names 0 toolkit)
    find_library(OSCULATE_${toolkit}_LIBRARY NAMES ${names} REQUIRED)
    mark_as_advanced(OSCULATE_${toolkit}_LIBRARY)
    target_link_libraries(osculate::opencascade INTERFACE ${OSCULATE_${toolkit}_LIBRARY})
  endforeach()
endif()
