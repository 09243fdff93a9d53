#include "panels/theme.h"

#include "fonts.h"

namespace marrow {
namespace {

Fonts the_fonts;  // belongs to the one ImGui context, as ImGui's own state does

// Latin with its accents, Greek, Cyrillic and signs: what the subset holds.
const ImWchar kTextRanges[] = {0x20,   0x7E,   0xA0,   0x17F,  0x218,  0x21B,  0x384,  0x3CE,
                               0x400,  0x45F,  0x490,  0x491,  0x2010, 0x2027, 0x20AC, 0x20AC,
                               0x2116, 0x2116, 0x2190, 0x2193, 0x2212, 0x2212, 0};
const ImWchar kTitleRanges[] = {0x20, 0x7E, 0x2010, 0x2027, 0};  // our own words only
const ImWchar kIconRanges[] = {0xE000, 0xF8FF, 0};

ImFont* add(const unsigned char* data, size_t size, float size_px, double dpr,
            const ImWchar* ranges) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  // Coarse screens need letters between their pixels, fine ones letters on them.
  config.OversampleH = dpr >= 1.5 ? 1 : 2;
  config.PixelSnapH = dpr >= 1.5;
  // ImGui takes the data as mutable and does not write to it.
  auto* bytes = const_cast<unsigned char*>(data);
  const auto scaled = static_cast<float>(size_px * dpr);
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(bytes, static_cast<int>(size), scaled, &config,
                                                    ranges);
}

}  // namespace

const Fonts& fonts() { return the_fonts; }

void buildFonts(double dpr) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->TexGlyphPadding = 2;
  the_fonts.regular = add(kUiFont, sizeof kUiFont, 15, dpr, kTextRanges);
  the_fonts.bold = add(kUiFontBold, sizeof kUiFontBold, 15, dpr, kTitleRanges);
  the_fonts.title = add(kUiFontBold, sizeof kUiFontBold, 20, dpr, kTitleRanges);
  the_fonts.icons = add(kIconFont, sizeof kIconFont, 20, dpr, kIconRanges);
  io.FontGlobalScale = static_cast<float>(1 / dpr);
  io.Fonts->Build();
}

void applyTheme() {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  ImGui::StyleColorsLight();
  style.WindowPadding = {14, 12};
  style.WindowRounding = Theme::kRounding;
  style.WindowBorderSize = 1;
  style.FrameRounding = 8;
  style.FramePadding = {10, 8};
  style.ItemSpacing = {8, 8};
  style.ItemInnerSpacing = {8, 6};
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.AntiAliasedLinesUseTex = false;
  const auto set = [&](ImGuiCol which, ImU32 color) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(color);
  };
  set(ImGuiCol_WindowBg, Theme::kPanel);
  set(ImGuiCol_Border, Theme::kHairline);
  set(ImGuiCol_Text, Theme::kText);
  set(ImGuiCol_TextDisabled, Theme::kSoftText);
  set(ImGuiCol_FrameBg, IM_COL32(41, 46, 60, 14));
  set(ImGuiCol_FrameBgHovered, Theme::kHover);
  set(ImGuiCol_FrameBgActive, Theme::kHover);
  set(ImGuiCol_TextSelectedBg, IM_COL32(37, 99, 174, 70));
  set(ImGuiCol_ScrollbarBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_ScrollbarGrab, Theme::kTrack);
  set(ImGuiCol_Separator, Theme::kHairline);
  set(ImGuiCol_NavHighlight, IM_COL32(0, 0, 0, 0));
}

}  // namespace marrow
