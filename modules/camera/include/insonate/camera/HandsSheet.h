#pragma once

#include <insonate/camera/TagBody.h>
#include <insonate/core/Result.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

enum class PaperSize : std::uint8_t { kA4, kLetter };

/// A point on a page, mm from its top left corner; x points right, y down.
struct SheetPoint {
  double x_mm = 0, y_mm = 0;
};

/// A printed tag: the place of its corners on the page.
struct SheetTag {
  int id = 0;
  std::array<SheetPoint, 4> corners;  ///< bottom left, bottom right, top right, top left, as the tag is read
};

enum class SheetLineKind : std::uint8_t {
  kCut,      ///< solid: cut here
  kFold,     ///< dashed: fold here, with the printed side outward
  kOutline,  ///< thick: outline on which the probe is held
  kRuler,    ///< thin: ruler for checking the scale of the print
};

struct SheetLine {
  SheetPoint from, to;
  SheetLineKind kind = SheetLineKind::kCut;
};

struct SheetText {
  SheetPoint at;  ///< left end of the base line
  double height_mm = 3;
  std::string text;
};

/// One page of the sheet, in true scale.
struct SheetPage {
  double width_mm = 0, height_mm = 0;
  std::vector<SheetTag> tags;
  std::vector<SheetLine> lines;
  std::vector<SheetText> texts;
};

/// Returns the page with the unfolded surface of a body: faces, tags, cut and fold lines, tabs for glue, and a ruler.
/// The printed side is outside. Fails if the surface is larger than the page.
Result<SheetPage> netPage(const TagBody& body, PaperSize paper);

/// Returns all pages for a trainee: nets of the built-in bodies, the board for the calibration of the lens, and the
/// outline on which the probe is held for the registration of the desk.
Result<std::vector<SheetPage>> handsSheet(PaperSize paper);

/// Writes the pages as a PDF file.
Result<void> writeHandsSheet(const std::vector<SheetPage>& pages, const std::filesystem::path& file);

}  // namespace insonate
