#include "Text.h"

#include <fontconfig/fontconfig.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <string>

namespace insonate::views {
namespace {

/// Empty if fontconfig knows no file.
std::string fontFile(int weight) {
  std::string file;
  FcPattern* wanted = FcPatternCreate();
  FcPatternAddString(wanted, FC_FAMILY, reinterpret_cast<const FcChar8*>("sans"));
  FcPatternAddInteger(wanted, FC_WEIGHT, weight);
  FcPatternAddBool(wanted, FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult result = FcResultNoMatch;
  if (FcPattern* found = FcFontMatch(nullptr, wanted, &result)) {
    FcChar8* name = nullptr;
    if (FcPatternGetString(found, FC_FILE, 0, &name) == FcResultMatch) file = reinterpret_cast<const char*>(name);
    FcPatternDestroy(found);
  }
  FcPatternDestroy(wanted);
  return file;
}

}  // namespace

void useSystemSans(vtkTextProperty& text, double size_px, Color color, bool bold) {
  static const std::string kRegular = fontFile(FC_WEIGHT_REGULAR), kBold = fontFile(FC_WEIGHT_BOLD);
  const std::string& file = bold ? kBold : kRegular;
  if (file.empty()) {
    text.SetFontFamilyToArial();
    text.SetBold(bold);
  } else {
    text.SetFontFamily(VTK_FONT_FILE);
    text.SetFontFile(file.c_str());
  }
  // VTK sizes are points at the text mapper's 72 dpi, which makes them pixels.
  text.SetFontSize(static_cast<int>(std::lround(size_px)));
  text.SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
  // Readable over bright anatomy.
  text.SetShadow(1);
  text.SetShadowOffset(1, -1);
}

}  // namespace insonate::views
