# Of several Pythons the first that has numpy: the one on the PATH, else the system's. The Python package is built for it.
if(NOT Python3_EXECUTABLE)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print(sys.executable)" OUTPUT_VARIABLE path RESULT_VARIABLE failed
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(failed EQUAL 0)
      set(Python3_EXECUTABLE ${path})
      break()
    endif()
  endforeach()
endif()
