# Emscripten's own toolchain file, wherever em++ is installed. emcmake is not used: the emulator it
# sets does not start on current versions of Node.
find_program(MARROW_EMXX em++)
if(NOT MARROW_EMXX)
  message(FATAL_ERROR "Emscripten is missing. Install it: apt-get install emscripten")
endif()
file(REAL_PATH "${MARROW_EMXX}" _emxx)
get_filename_component(_emscripten_root "${_emxx}" DIRECTORY)
find_program(MARROW_NODE NAMES node nodejs)
if(NOT MARROW_NODE)
  message(FATAL_ERROR "Node is missing. Install it: apt-get install nodejs")
endif()
set(CMAKE_CROSSCOMPILING_EMULATOR "${MARROW_NODE}" CACHE FILEPATH "Runs what was compiled")
include("${_emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
