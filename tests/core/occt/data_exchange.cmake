# What the tests read STEP and IGES models with: osculate_data_exchange. OpenCASCADE 7.8 renamed the
# libraries (TKSTEP to TKDESTEP, TKIGES to TKDEIGES).
add_library(osculate_data_exchange INTERFACE)
foreach(names "TKDESTEP;TKSTEP" "TKDEIGES;TKIGES" TKXSBase)
  list(GET names 0 name)
  find_library(OSCULATE_${name}_LIBRARY NAMES ${names} REQUIRED)
  mark_as_advanced(OSCULATE_${name}_LIBRARY)
  target_link_libraries(osculate_data_exchange INTERFACE ${OSCULATE_${name}_LIBRARY})
endforeach()
