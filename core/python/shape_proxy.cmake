# The fast way from FreeCAD's shapes into _core, where SWIG is there to write its runtime's header.
# Without it the module is complete too, but takes shapes through a file (see shapes.py).
find_program(OSCULATE_SWIG NAMES swig swig4.0 DOC "SWIG, of the version that FreeCAD was built with")
if(OSCULATE_SWIG)
  set(swig_folder ${CMAKE_CURRENT_BINARY_DIR}/swig)
  add_custom_command(OUTPUT ${swig_folder}/swigpyrun.h
    COMMAND ${CMAKE_COMMAND} -E make_directory ${swig_folder}
    COMMAND ${OSCULATE_SWIG} -python -external-runtime ${swig_folder}/swigpyrun.h
    COMMENT "Writing the header of SWIG's runtime" VERBATIM)
  target_sources(_core PRIVATE shape_proxy.cpp shape_proxy.h ${swig_folder}/swigpyrun.h)
  target_include_directories(_core SYSTEM PRIVATE ${swig_folder})
  target_compile_definitions(_core PRIVATE OSCULATE_HAS_SHAPE_PROXY)
else()
  message(STATUS "SWIG not found: shapes of FreeCAD will be handed over through a file (slower)")
endif()
