#include "ui/fonts.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>

#include <stb/stb_truetype.h>

#include "ui/icons.hpp"

namespace replan::ui {
namespace {

/// A face of the design: where Debian and its kin keep it, which package brings it.
struct Face {
  const char* name;
  const char* package;
  std::array<const char*, 3> paths;
};

constexpr Face kInter = {
    "Inter",
    "fonts-inter",
    {"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
     "/usr/share/fonts/inter/Inter-Regular.otf"}};
constexpr Face kInterBold = {
    "Inter SemiBold",
    "fonts-inter",
    {"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
     "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf", "/usr/share/fonts/inter/Inter-SemiBold.otf"}};
constexpr Face kMono = {"JetBrains Mono",
                        "fonts-jetbrains-mono",
                        {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
                         "/usr/share/fonts/jetbrains-mono/JetBrainsMono-Regular.ttf",
                         "/usr/share/fonts/TTF/JetBrainsMono-Regular.ttf"}};
constexpr Face kMonoBold = {"JetBrains Mono SemiBold",
                            "fonts-jetbrains-mono",
                            {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-SemiBold.ttf",
                             "/usr/share/fonts/jetbrains-mono/JetBrainsMono-SemiBold.ttf",
                             "/usr/share/fonts/TTF/JetBrainsMono-SemiBold.ttf"}};
constexpr Face kAwesome = {"Font Awesome 4.7",
                           "fonts-font-awesome",
                           {"/usr/share/fonts/opentype/font-awesome/FontAwesome.otf",
                            "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf",
                            "/usr/share/fonts-font-awesome/fonts/FontAwesome.otf"}};
constexpr Face kSans = {"DejaVu Sans",
                        "fonts-dejavu-core",
                        {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                         "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"}};
constexpr Face kSansMono = {
    "DejaVu Sans Mono",
    "fonts-dejavu-core",
    {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
     "/usr/share/fonts/dejavu/DejaVuSansMono.ttf"}};
constexpr Face kChinese = {
    "WenQuanYi Micro Hei",
    "fonts-wqy-microhei",
    {"/usr/share/fonts/truetype/wqy/wqy-microhei.ttc", "/usr/share/fonts/wqy-microhei/wqy-microhei.ttc",
     "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc"}};

enum class Content {
  words,    ///< text, icons and the language's own characters
  figures,  ///< text
  icons,
};

struct Role {
  ImFont* Fonts::*slot;
  const Face* face;
  const Face* stand_in;
  float em;    ///< size as type is measured: the side of the em square
  float line;  ///< height of a line
  Content content;
  float tracking = 0;  ///< space between characters, in em
};

constexpr Role kRoles[] = {
    {&Fonts::ui, &kInter, &kSans, 13, 16, Content::words},
    {&Fonts::title, &kInterBold, &kSans, 13, 16, Content::words, 0.02f},
    {&Fonts::section, &kInterBold, &kSans, 12, 16, Content::words, 0.02f},
    {&Fonts::small, &kInter, &kSans, 11, 14, Content::words},
    {&Fonts::heading, &kInterBold, &kSans, 18, 22, Content::words},
    {&Fonts::mono, &kMono, &kSansMono, 12, 16, Content::words},
    {&Fonts::mono_bold, &kMonoBold, &kSansMono, 12, 16, Content::figures},
    {&Fonts::mono_small, &kMono, &kSansMono, 10, 14, Content::figures},
    {&Fonts::icons, &kAwesome, nullptr, 16, 16, Content::icons},
};

// Latin, Greek and Cyrillic in full; of the symbols, those that planners and their pages use.
constexpr ImWchar kTextRanges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x400, 0x45F,
                                   0x2010, 0x2027, 0x2030, 0x203A, 0};
constexpr const char* kSymbols =
    "←↑→↓↔↕↖↗↘↙↦⇐⇒⇔∀∂∃∅∈∉∋∏∑−∓∗∘√∝∞∠∧∨∩∪∫∴≈≠≡≤≥≪≫⊂⊃⊆⊇⊕⊗⊥⋅⌈⌉⌊⌋²³¹⁰⁴⁵⁶⁷⁸⁹⁺⁻ⁿ₀₁₂₃₄₅₆₇₈₉€ℓℝℤ™"
    "■□▪▫▲△▶▷▼▽◀◁◆◇○●◦★☆✓✗⌘⇧⏎␣⟨⟩ⓘ⚠";
constexpr ImWchar kIconRange[] = {icon::kFirst, icon::kLast, 0};

/// The bytes of one font file and what ImGui must know to bake it at a given em.
struct Loaded {
  std::vector<unsigned char> bytes;
  float height_per_em = 1.0f;  ///< ImGui sizes fonts by ascent + descent
};

std::optional<Loaded> load(const Face& face) {
  for (const char* path : face.paths) {
    std::ifstream file(path, std::ios::binary);
    if (!file) continue;
    Loaded loaded;
    loaded.bytes.assign(std::istreambuf_iterator<char>(file), {});
    stbtt_fontinfo info;
    const int offset = stbtt_GetFontOffsetForIndex(loaded.bytes.data(), 0);
    if (offset < 0 || stbtt_InitFont(&info, loaded.bytes.data(), offset) == 0) continue;
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
    loaded.height_per_em =
        static_cast<float>(ascent - descent) * stbtt_ScaleForMappingEmToPixels(&info, 1.0f);
    return loaded;
  }
  return std::nullopt;
}

/// Bakes the roles; lives until the atlas is built, because the atlas refers to its bytes and ranges.
class Baker {
 public:
  Baker(ImFontAtlas& atlas, const FontOptions& options) : atlas_(atlas), scale_(options.scale) {
    ImFontGlyphRangesBuilder text;
    text.AddRanges(kTextRanges);
    text.AddText(kSymbols);
    text.BuildRanges(&text_);
    ImFontGlyphRangesBuilder extra;
    extra.AddText(options.also.c_str());
    if (options.chinese) extra.AddRanges(atlas.GetGlyphRangesChineseSimplifiedCommon());
    extra.BuildRanges(&extra_);
  }

  ImFont* bake(const Role& role) {
    if (role.content == Content::icons) {
      ImFont* icons = add(*role.face, role, kIconRange, nullptr);
      return icons != nullptr ? icons : bake_default(role);
    }
    // Faces in order of preference: a later one only fills in the characters that the earlier ones lack.
    ImFont* font = nullptr;
    for (const Face* next : {role.face, role.stand_in, &kSans}) {
      if (ImFont* filled = add(*next, role, text_.Data, font); font == nullptr) font = filled;
    }
    if (font == nullptr) font = bake_default(role);
    if (role.content == Content::words) add_words(role, font);
    return font;
  }

  [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }

 private:
  /// The face's bytes, read once; null and a notice, once, if it is not installed.
  const Loaded* face(const Face& wanted) {
    const auto [entry, is_new] = loaded_.try_emplace(&wanted);
    if (is_new) {
      entry->second = load(wanted);
      if (!entry->second) {
        notices_.push_back(std::string("The font ") + wanted.name + " is not installed (package " +
                           wanted.package + "), so the window looks other than intended.");
      }
    }
    return entry->second ? &*entry->second : nullptr;
  }

  [[nodiscard]] bool needs_chinese() const {
    for (int i = 0; i + 1 < extra_.Size; i += 2) {
      if (extra_[i + 1] >= 0x2E80 && extra_[i] < 0xE000) return true;
    }
    return false;
  }

  void add_words(const Role& role, ImFont* font) {
    add(kAwesome, role, kIconRange, font);
    if (extra_.Size <= 1) return;
    add(*role.face, role, extra_.Data, font);
    if (needs_chinese()) add(kChinese, role, extra_.Data, font);
  }

  /// Adds a face to `font`, or begins a font with it if `font` is null; returns the font, or null if missing.
  ImFont* add(const Face& wanted, const Role& role, const ImWchar* ranges, ImFont* font) {
    const Loaded* loaded = face(wanted);
    if (loaded == nullptr) return nullptr;
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.MergeMode = font != nullptr;
    config.DstFont = font;
    config.GlyphRanges = ranges;
    // Words stand at fractions of a pixel and need finer glyphs; icons and Chinese stand on whole ones.
    const bool whole = &wanted == &kAwesome || &wanted == &kChinese;
    config.OversampleH = whole ? 1 : scale_ < 1.5f ? 3 : 2;
    config.OversampleV = 1;
    config.PixelSnapH = whole;
    if (&wanted == role.face) config.GlyphExtraSpacing.x = role.tracking * role.em * scale_;
    // Font Awesome is drawn on a grid of 14 units, one more than the words it stands beside.
    const float em =
        role.em * scale_ * (&wanted == &kAwesome && role.content == Content::words ? 14.0f / 13.0f : 1.0f);
    // ImGui does not write to the bytes it does not own.
    auto* bytes = const_cast<unsigned char*>(loaded->bytes.data());
    return atlas_.AddFontFromMemoryTTF(bytes, static_cast<int>(loaded->bytes.size()),
                                       em * loaded->height_per_em, &config);
  }

  ImFont* bake_default(const Role& role) {
    ImFontConfig config;
    config.SizePixels = std::round(role.em * scale_);
    return atlas_.AddFontDefault(&config);
  }

  ImFontAtlas& atlas_;
  float scale_;
  ImVector<ImWchar> text_;   // what every role holds
  ImVector<ImWchar> extra_;  // what the language asks for on top
  std::map<const Face*, std::optional<Loaded>> loaded_;
  std::vector<std::string> notices_;
};

}  // namespace

FontReport build_fonts(ImFontAtlas& atlas, const FontOptions& options) {
  atlas.Clear();
  atlas.TexGlyphPadding = 1;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  Baker baker(atlas, options);
  FontReport report;
  for (const Role& role : kRoles) report.fonts.*role.slot = baker.bake(role);
  atlas.Build();
  for (const Role& role : kRoles) {
    // Whole, even line heights keep rows on the pixel grid; glyphs are placed in pixels, so this moves none.
    (report.fonts.*role.slot)->FontSize = std::round(role.line * options.scale);
  }
  atlas.ClearInputData();
  report.notices = baker.notices();
  return report;
}

}  // namespace replan::ui
