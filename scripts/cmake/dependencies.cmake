# Finds what Marrow is built with. Everything comes from the system; nothing is searched for in the
# WebAssembly sysroot. Where a library is somewhere else, -DMARROW_<NAME>_INCLUDE_DIR=… says so.

# marrow_missing(WHAT HOW): ends the configuration with one line.
function(marrow_missing what how)
  message(FATAL_ERROR " ${what} is missing. Install it: ${how}")
endfunction()

# marrow_find_header(VAR FILE WHAT PACKAGE [PATH_SUFFIX…]): the folder that holds FILE.
function(marrow_find_header var file what package)
  find_path(${var} ${file} PATHS /usr/include /usr/local/include /opt/homebrew/include
            PATH_SUFFIXES ${ARGN} NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ${var})
    marrow_missing("${what}" "apt-get install ${package}, or set -D${var}=FOLDER")
  endif()
  mark_as_advanced(${var})
endfunction()

marrow_find_header(MARROW_EIGEN_INCLUDE_DIR Eigen/Core "Eigen" libeigen3-dev eigen3)
marrow_find_header(MARROW_CGAL_INCLUDE_DIR CGAL/Straight_skeleton_2.h "CGAL" libcgal-dev)
marrow_find_header(MARROW_BOOST_INCLUDE_DIR boost/config.hpp "Boost" libboost-dev)
marrow_find_header(MARROW_JSON_INCLUDE_DIR nlohmann/json.hpp "nlohmann/json" nlohmann-json3-dev)
marrow_find_header(MARROW_TINYGLTF_INCLUDE_DIR tiny_gltf.h "tinygltf" libtinygltf-dev)

# marrow_link_headers(FOLDER): a folder with links to just the libraries, because /usr/include on
# em++'s path would shadow the sysroot's C library.
function(marrow_link_headers folder)
  file(MAKE_DIRECTORY "${folder}")
  foreach(entry IN ITEMS "${MARROW_EIGEN_INCLUDE_DIR}/Eigen" "${MARROW_CGAL_INCLUDE_DIR}/CGAL"
                         "${MARROW_BOOST_INCLUDE_DIR}/boost" "${MARROW_JSON_INCLUDE_DIR}/nlohmann"
                         "${MARROW_TINYGLTF_INCLUDE_DIR}/tiny_gltf.h")
    get_filename_component(name "${entry}" NAME)
    file(CREATE_LINK "${entry}" "${folder}/${name}" SYMBOLIC)
  endforeach()
endfunction()

add_library(marrow_headers INTERFACE)  # Eigen, nlohmann/json and tinygltf
add_library(marrow_cgal_headers INTERFACE)  # CGAL and Boost, with the flags they need
if(EMSCRIPTEN)
  marrow_link_headers("${CMAKE_BINARY_DIR}/include")
  target_include_directories(marrow_headers SYSTEM INTERFACE "${CMAKE_BINARY_DIR}/include")
  target_include_directories(marrow_cgal_headers SYSTEM INTERFACE "${CMAKE_BINARY_DIR}/include")
else()
  target_include_directories(marrow_headers SYSTEM INTERFACE "${MARROW_EIGEN_INCLUDE_DIR}"
                             "${MARROW_JSON_INCLUDE_DIR}" "${MARROW_TINYGLTF_INCLUDE_DIR}")
  target_include_directories(marrow_cgal_headers SYSTEM INTERFACE "${MARROW_CGAL_INCLUDE_DIR}"
                             "${MARROW_BOOST_INCLUDE_DIR}")
endif()

# WebAssembly cannot change the rounding mode: without ALWAYS_ROUND_TO_NEAREST CGAL's predicates are
# wrong in silence, and with it CGAL's own assertions fire. MP_Float is faster there than Boost's
# rationals.
target_compile_definitions(marrow_cgal_headers INTERFACE CGAL_HAS_NO_THREADS CGAL_NDEBUG)
find_library(MARROW_GMP_LIBRARY gmp)
find_library(MARROW_MPFR_LIBRARY mpfr)
mark_as_advanced(MARROW_GMP_LIBRARY MARROW_MPFR_LIBRARY)
if(EMSCRIPTEN)
  target_compile_definitions(marrow_cgal_headers INTERFACE CGAL_DISABLE_GMP CGAL_DO_NOT_USE_BOOST_MP
                             CGAL_ALWAYS_ROUND_TO_NEAREST)
elseif(MARROW_GMP_LIBRARY AND MARROW_MPFR_LIBRARY)
  target_compile_definitions(marrow_cgal_headers INTERFACE CGAL_USE_GMP CGAL_USE_MPFR)
  target_compile_options(marrow_cgal_headers INTERFACE -frounding-math)
  target_link_libraries(marrow_cgal_headers INTERFACE "${MARROW_MPFR_LIBRARY}"
                        "${MARROW_GMP_LIBRARY}")
else()
  message(STATUS "GMP or MPFR is missing (apt-get install libgmp-dev libmpfr-dev): CGAL is slower")
  target_compile_definitions(marrow_cgal_headers INTERFACE CGAL_DISABLE_GMP
                             CGAL_DO_NOT_USE_BOOST_MP)
  target_compile_options(marrow_cgal_headers INTERFACE -frounding-math)
endif()

# What only the app needs: IMGUI_DIR, and natively the targets glfw and OpenGL::GL.
set(MARROW_IMGUI_DIR "" CACHE PATH "Folder with the source of Dear ImGui 1.86")
macro(marrow_find_app_dependencies)
  # Dear ImGui is compiled from its source for both targets: what scripts/setup unpacked, a folder
  # that the user names, or a download of the same version.
  set(IMGUI_DIR "${MARROW_IMGUI_DIR}")
  if(NOT IMGUI_DIR AND EXISTS "${CMAKE_SOURCE_DIR}/.cache/imgui/imgui.cpp")
    set(IMGUI_DIR "${CMAKE_SOURCE_DIR}/.cache/imgui")
  endif()
  if(NOT IMGUI_DIR)
    include(FetchContent)
    FetchContent_Declare(imgui GIT_REPOSITORY https://github.com/ocornut/imgui.git GIT_TAG v1.86
                         GIT_SHALLOW ON)
    message(STATUS "Downloading the source of Dear ImGui 1.86")
    FetchContent_MakeAvailable(imgui)
    set(IMGUI_DIR "${imgui_SOURCE_DIR}")
  endif()
  if(NOT EXISTS "${IMGUI_DIR}/backends/imgui_impl_opengl3.cpp")
    marrow_missing("The source of Dear ImGui 1.86"
                   "scripts/setup, or set -DMARROW_IMGUI_DIR=FOLDER")
  endif()

  if(NOT EMSCRIPTEN)
    find_package(glfw3 3.3 CONFIG QUIET)
    if(NOT TARGET glfw)
      marrow_missing("GLFW" "apt-get install libglfw3-dev, or set -DMARROW_APP=OFF")
    endif()
    set(OpenGL_GL_PREFERENCE GLVND)
    find_package(OpenGL QUIET)
    if(NOT TARGET OpenGL::GL)
      marrow_missing("OpenGL" "apt-get install libgl-dev, or set -DMARROW_APP=OFF")
    endif()
  endif()
endmacro()
