#include <insonate/camera/HandsSheet.h>
#include <insonate/core/AtomicFile.h>

#include <cairo-pdf.h>
#include <cairo.h>

#include <array>
#include <memory>

namespace insonate {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextDeleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// Draws black cells as one path, so that no light seams appear between cells.
void drawTag(cairo_t* cairo, const SheetTag& tag) {
  const TagPattern& pattern = tagPattern(tag.id);
  const SheetPoint &corner = tag.corners[3], &right = tag.corners[2], &down = tag.corners[0];
  const auto at = [&](double column, double row) {
    const double u = (column - 1) / kTagCells, v = (row - 1) / kTagCells;
    return SheetPoint{corner.x_mm + u * (right.x_mm - corner.x_mm) + v * (down.x_mm - corner.x_mm),
                      corner.y_mm + u * (right.y_mm - corner.y_mm) + v * (down.y_mm - corner.y_mm)};
  };
  const auto addCell = [&](double left, double top, double width, double height) {
    const std::array<SheetPoint, 4> points{at(left, top), at(left + width, top), at(left + width, top + height),
                                           at(left, top + height)};
    cairo_move_to(cairo, points[0].x_mm, points[0].y_mm);
    for (std::size_t i = 1; i < 4; ++i) cairo_line_to(cairo, points[i].x_mm, points[i].y_mm);
    cairo_close_path(cairo);
  };
  // A black square, and white cells on it.
  cairo_set_source_rgb(cairo, 0, 0, 0);
  addCell(1, 1, kTagCells, kTagCells);
  cairo_fill(cairo);
  cairo_set_source_rgb(cairo, 1, 1, 1);
  for (int row = 1; row <= kTagCells; ++row)
    for (int column = 1; column <= kTagCells; ++column)
      if (pattern[std::size_t(row) * kTagCellsWithBorder + std::size_t(column)]) addCell(column, row, 1, 1);
  cairo_fill(cairo);
}

void drawLine(cairo_t* cairo, const SheetLine& line) {
  constexpr double kDashes_mm[2] = {1.5, 1.5};
  const bool isFold = line.kind == SheetLineKind::kFold;
  const double gray = isFold ? 0.6 : line.kind == SheetLineKind::kCut ? 0.35 : 0;
  cairo_set_source_rgb(cairo, gray, gray, gray);
  cairo_set_line_width(cairo, line.kind == SheetLineKind::kOutline ? 0.8 : 0.15);
  cairo_set_dash(cairo, kDashes_mm, isFold ? 2 : 0, 0);
  cairo_move_to(cairo, line.from.x_mm, line.from.y_mm);
  cairo_line_to(cairo, line.to.x_mm, line.to.y_mm);
  cairo_stroke(cairo);
}

void drawPage(cairo_t* cairo, const SheetPage& page) {
  for (const SheetLine& line : page.lines) drawLine(cairo, line);
  for (const SheetTag& tag : page.tags) drawTag(cairo, tag);
  cairo_set_source_rgb(cairo, 0, 0, 0);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (const SheetText& text : page.texts) {
    cairo_set_font_size(cairo, text.height_mm);
    cairo_move_to(cairo, text.at.x_mm, text.at.y_mm);
    cairo_show_text(cairo, text.text.c_str());
  }
}

}  // namespace

Result<void> writeHandsSheet(const std::vector<SheetPage>& pages, const std::filesystem::path& file) {
  if (pages.empty()) return fail("There are no pages to write.");
  return writeAtomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    const std::unique_ptr<cairo_surface_t, SurfaceDeleter> surface(
        cairo_pdf_surface_create(beside.c_str(), pages[0].width_mm * kPointsPerMm, pages[0].height_mm * kPointsPerMm));
    for (const SheetPage& page : pages) {
      cairo_pdf_surface_set_size(surface.get(), page.width_mm * kPointsPerMm, page.height_mm * kPointsPerMm);
      const std::unique_ptr<cairo_t, ContextDeleter> cairo(cairo_create(surface.get()));
      cairo_scale(cairo.get(), kPointsPerMm, kPointsPerMm);
      drawPage(cairo.get(), page);
      cairo_show_page(cairo.get());
    }
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
      return fail(beside.string() + ": cannot be written: " + cairo_status_to_string(status) +
                  ". Check the folder and the space on the disk.");
    return {};
  });
}

}  // namespace insonate
