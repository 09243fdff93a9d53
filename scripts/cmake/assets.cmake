# Shaders, fonts, icons and samples, compiled into the app. marrow_add_assets() makes the library
# marrow_assets with four headers, written to the build folder:
#   shaders.h  shaderSource("part.vert"): the text of shaders/part.vert
#   fonts.h    kUiFont, kUiFontBold, kIconFont: OpenType files, cut down to what is used
#   icons.h    kIconUndo2 for the line "undo-2" of web/icons.txt: UTF-8 text in the icon font
#   samples.h  samples(): the drawings of public/samples
# The icons' names and pictures: https://lucide.dev/icons

# What names may hold: Latin, Greek and Cyrillic letters. Headings are our own words.
set(MARROW_UI_CHARACTERS
    U+0020-007E,U+00A0-017F,U+0218-021B,U+0384-03CE,U+0400-045F,U+0490-0491,U+2010-2027,U+2032)
string(APPEND MARROW_UI_CHARACTERS ",U+2033,U+20AC,U+2116,U+2190-2193,U+2212,U+221A")
set(MARROW_HEADING_CHARACTERS U+0020-007E,U+2010-2027)

# marrow_find_font(VAR NAMES…)
function(marrow_find_font var)
  find_file(${var} NAMES ${ARGN} NO_CMAKE_FIND_ROOT_PATH
            PATHS /usr/share/fonts /usr/local/share/fonts /Library/Fonts "$ENV{HOME}/Library/Fonts"
            PATH_SUFFIXES opentype/inter truetype/inter inter)
  if(NOT ${var})
    list(GET ARGN 0 name)
    marrow_missing("The font ${name}" "apt-get install fonts-inter, or set -D${var}=FILE")
  endif()
  mark_as_advanced(${var})
endfunction()

# marrow_subset_font(VAR NAME FONT CHARACTERS): a command that writes the font with just these
# characters to generated/NAME.
function(marrow_subset_font var name font characters)
  set(out "${CMAKE_BINARY_DIR}/generated/${name}")
  add_custom_command(
    OUTPUT "${out}"
    COMMAND "${MARROW_FONTTOOLS_PYTHON}" -m fontTools.subset "${font}" "--unicodes=${characters}"
            --layout-features= --no-hinting "--output-file=${out}"
    DEPENDS "${font}" VERBATIM)
  set(${var} "${out}" PARENT_SCOPE)
endfunction()

# The Python that has fontTools; a Python from elsewhere may come first on the path.
function(marrow_find_fonttools)
  foreach(python IN ITEMS /usr/bin/python3 python3 python)
    execute_process(COMMAND "${python}" -c "import fontTools.subset" RESULT_VARIABLE failed
                    OUTPUT_QUIET ERROR_QUIET)
    if(NOT failed)
      set(MARROW_FONTTOOLS_PYTHON "${python}" CACHE STRING "A Python that has fontTools")
      mark_as_advanced(MARROW_FONTTOOLS_PYTHON)
      return()
    endif()
  endforeach()
  marrow_missing("fontTools" "apt-get install python3-fonttools")
endfunction()

# marrow_write_icons(VAR): writes generated/icons.h; VAR gets the characters, as U+E001,U+E002.
function(marrow_write_icons var)
  set(list_file "${CMAKE_SOURCE_DIR}/web/icons.txt")
  file(READ "${MARROW_LUCIDE_DIR}/lucide.css" css)
  file(STRINGS "${list_file}" names REGEX "^[a-z0-9-]+$")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list_file}")
  set(header "// Written by scripts/cmake/assets.cmake from web/icons.txt.\n#pragma once\n\n")
  string(APPEND header "namespace marrow {\n\n")
  set(characters)
  foreach(name IN LISTS names)
    if(NOT css MATCHES "\\.icon-${name}::?before *{ *content: *\"\\\\([0-9a-f]+)\"")
      message(FATAL_ERROR "web/icons.txt: the icon font has no \"${name}\"")
    endif()
    set(code "${CMAKE_MATCH_1}")
    list(APPEND characters "U+${code}")
    string(REPLACE "-" ";" words "${name}")
    set(constant "kIcon")
    foreach(word IN LISTS words)
      string(SUBSTRING "${word}" 0 1 first)
      string(SUBSTRING "${word}" 1 -1 rest)
      string(TOUPPER "${first}" first)
      string(APPEND constant "${first}${rest}")
    endforeach()
    string(APPEND header "inline constexpr const char* ${constant} = \"\\u${code}\";\n")
  endforeach()
  string(APPEND header "\n}  // namespace marrow\n")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/icons.h" CONTENT "${header}" @ONLY)
  string(REPLACE ";" "," characters "${characters}")
  set(${var} "${characters}" PARENT_SCOPE)
endfunction()

function(marrow_add_assets)
  marrow_find_font(MARROW_UI_FONT Inter-Regular.otf Inter-Regular.ttf)
  marrow_find_font(MARROW_UI_FONT_BOLD Inter-SemiBold.otf Inter-SemiBold.ttf)
  find_path(MARROW_LUCIDE_DIR lucide.css NO_CMAKE_FIND_ROOT_PATH
            PATHS "${CMAKE_SOURCE_DIR}/node_modules/lucide-static/font")
  if(NOT MARROW_LUCIDE_DIR)
    marrow_missing("The icon font" "npm ci, or set -DMARROW_LUCIDE_DIR=FOLDER")
  endif()
  mark_as_advanced(MARROW_LUCIDE_DIR)
  marrow_find_fonttools()

  marrow_write_icons(icon_characters)
  marrow_subset_font(ui_font ui_font.otf "${MARROW_UI_FONT}" "${MARROW_UI_CHARACTERS}")
  marrow_subset_font(ui_font_bold ui_font_bold.otf "${MARROW_UI_FONT_BOLD}"
                     "${MARROW_HEADING_CHARACTERS}")
  marrow_subset_font(icon_font icon_font.ttf "${MARROW_LUCIDE_DIR}/lucide.ttf"
                     "${icon_characters}")

  set(embed "${CMAKE_SOURCE_DIR}/scripts/cmake/embed.cmake")
  set(out "${CMAKE_BINARY_DIR}/generated")
  file(GLOB shaders CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/shaders/*.vert"
       "${CMAKE_SOURCE_DIR}/shaders/*.frag" "${CMAKE_SOURCE_DIR}/shaders/*.glsl")
  add_custom_command(
    OUTPUT "${out}/shaders.h" "${out}/shaders.cpp"
    COMMAND "${CMAKE_COMMAND}" -DKIND=shaders "-DOUT=${out}" "-DFILES=${shaders}" -P "${embed}"
    DEPENDS ${shaders} "${embed}" VERBATIM)
  add_custom_command(
    OUTPUT "${out}/fonts.h" "${out}/fonts.cpp"
    COMMAND "${CMAKE_COMMAND}" -DKIND=fonts "-DOUT=${out}"
            "-DFILES=${ui_font};${ui_font_bold};${icon_font}" -P "${embed}"
    DEPENDS "${ui_font}" "${ui_font_bold}" "${icon_font}" "${embed}" VERBATIM)
  file(GLOB samples CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/public/samples/*.json")
  add_custom_command(
    OUTPUT "${out}/samples.h" "${out}/samples.cpp"
    COMMAND "${CMAKE_COMMAND}" -DKIND=samples "-DOUT=${out}" "-DFILES=${samples}" -P "${embed}"
    DEPENDS ${samples} "${embed}" VERBATIM)
  add_library(marrow_assets STATIC "${out}/shaders.cpp" "${out}/shaders.h" "${out}/fonts.cpp"
              "${out}/fonts.h" "${out}/samples.cpp" "${out}/samples.h")
  target_include_directories(marrow_assets PUBLIC "${out}")
endfunction()

# marrow_add_site(FOLDER): copies public/ there; the app puts its own files beside it.
function(marrow_add_site folder)
  file(GLOB_RECURSE pages RELATIVE "${CMAKE_SOURCE_DIR}/public" CONFIGURE_DEPENDS
       "${CMAKE_SOURCE_DIR}/public/*")
  set(copies)
  foreach(page IN LISTS pages)
    add_custom_command(
      OUTPUT "${folder}/${page}"
      COMMAND "${CMAKE_COMMAND}" -E copy "${CMAKE_SOURCE_DIR}/public/${page}" "${folder}/${page}"
      DEPENDS "${CMAKE_SOURCE_DIR}/public/${page}" VERBATIM)
    list(APPEND copies "${folder}/${page}")
  endforeach()
  add_custom_target(marrow_site ALL DEPENDS ${copies})
endfunction()
