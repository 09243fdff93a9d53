# cmake -DKIND=shaders|fonts|samples -DOUT=FOLDER -DFILES=A;B -P embed.cmake: writes files as C++ sources.

# write(NAME TEXT)
function(write name text)
  file(WRITE "${OUT}/${name}" "// Written by scripts/cmake/embed.cmake.\n${text}")
endfunction()

if(KIND STREQUAL "shaders")
  write(shaders.h "#pragma once

#include <string_view>

namespace marrow {

/// The text of shaders/<file>; empty where there is no such file.
std::string_view shaderSource(std::string_view file);

}  // namespace marrow
")
  set(text "#include \"shaders.h\"

namespace marrow {

std::string_view shaderSource(std::string_view file) {
")
  foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    # Brackets and semicolons mean something to CMake's lists, but this is one string throughout.
    file(READ "${file}" source)
    string(APPEND text "  if (file == \"${name}\") return R\"glsl(${source})glsl\";\n")
  endforeach()
  string(APPEND text "  return {};\n}\n\n}  // namespace marrow\n")
  write(shaders.cpp "${text}")
elseif(KIND STREQUAL "samples")
  list(LENGTH FILES count)
  write(samples.h "#pragma once

#include <array>
#include <string_view>

namespace marrow {

/// A drawing of public/samples.
struct Sample {
  std::string_view file;  // \"dog.json\"
  std::string_view name;  // \"Dog\"
  std::string_view text;
};
const std::array<Sample, ${count}>& samples();

}  // namespace marrow
")
  set(text "#include \"samples.h\"\n\nnamespace marrow {\nnamespace {\n\n")
  string(APPEND text "constexpr std::array<Sample, ${count}> kSamples{{\n")
  foreach(file IN LISTS FILES)
    get_filename_component(base "${file}" NAME)
    file(READ "${file}" source)
    string(JSON name GET "${source}" title)
    string(APPEND text "    {\"${base}\", \"${name}\", R\"json(${source})json\"},\n")
  endforeach()
  string(APPEND text "}};\n\n}  // namespace\n\n"
         "const std::array<Sample, ${count}>& samples() { return kSamples; }\n\n"
         "}  // namespace marrow\n")
  write(samples.cpp "${text}")
elseif(KIND STREQUAL "fonts")
  set(header "#pragma once

#include <cstddef>

namespace marrow {

// OpenType files.
")
  set(text "#include \"fonts.h\"\n\nnamespace marrow {\n\n")
  foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME_WE)
    string(REPLACE "_" ";" words "${name}")
    set(constant "k")
    foreach(word IN LISTS words)
      string(SUBSTRING "${word}" 0 1 first)
      string(SUBSTRING "${word}" 1 -1 rest)
      string(TOUPPER "${first}" first)
      string(APPEND constant "${first}${rest}")
    endforeach()
    file(READ "${file}" hex HEX)
    string(LENGTH "${hex}" digits)
    math(EXPR size "${digits} / 2")
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
    string(APPEND header "extern const unsigned char ${constant}[${size}];\n")
    string(APPEND text "const unsigned char ${constant}[${size}] = {\n${bytes}};\n")
  endforeach()
  write(fonts.h "${header}\n}  // namespace marrow\n")
  write(fonts.cpp "${text}\n}  // namespace marrow\n")
endif()
