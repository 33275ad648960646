# sudar_scenario(NAME FILE): the target scenario_NAME, a plugin NAME.so of the scenario in FILE.
# Installed beside the package's configuration: a scenario outside this repository is built in the same way.
function(sudar_scenario name file)
  get_target_property(engine sudar::sudar ALIASED_TARGET)
  if(NOT engine)
    set(engine sudar::sudar)
  endif()
  get_target_property(kind ${engine} TYPE)
  if(NOT kind STREQUAL "SHARED_LIBRARY")
    message(FATAL_ERROR "a plugin needs the engine as a shared library: else it would bring an engine of its own")
  endif()
  add_library(scenario_${name} MODULE ${file})
  set_target_properties(scenario_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_definitions(scenario_${name} PRIVATE SUDAR_SCENARIO_NAME=${name})
  # A unique symbol would keep the library loaded for ever.
  target_compile_options(scenario_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  target_link_libraries(scenario_${name} PRIVATE sudar::sudar)
endfunction()
