#include "attempt/Canvas.h"

#include <cairo.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace insonate::video {

struct Canvas::State {
  State(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), cairo(cairo_create(surface)) {}
  ~State() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void use(Ink ink, double opacity = 1) {
    cairo_set_source_rgba(cairo, ink.red / 255.0, ink.green / 255.0, ink.blue / 255.0, opacity);
  }

  cairo_surface_t* surface;
  cairo_t* cairo;
};

Canvas::Canvas(int width, int height) : state_(std::make_unique<State>(width, height)) {}
Canvas::~Canvas() = default;

void Canvas::fill(const Box& box, Ink ink, double opacity) {
  state_->use(ink, opacity);
  cairo_rectangle(state_->cairo, box.left, box.top, box.width, box.height);
  cairo_fill(state_->cairo);
}

void Canvas::line(double x0, double y0, double x1, double y1, double width_px, Ink ink) {
  state_->use(ink);
  cairo_set_line_width(state_->cairo, width_px);
  cairo_move_to(state_->cairo, x0, y0);
  cairo_line_to(state_->cairo, x1, y1);
  cairo_stroke(state_->cairo);
}

void Canvas::disc(double x, double y, double radius_px, Ink ink) {
  state_->use(ink);
  cairo_arc(state_->cairo, x, y, radius_px, 0, 2 * std::numbers::pi);
  cairo_fill(state_->cairo);
}

void Canvas::image(const BModeImage& image, const ColorImage& color, const Box& box) {
  std::vector<std::uint32_t> pixels(image.gray.size());
  std::ranges::transform(image.gray, pixels.begin(), [](std::uint8_t gray) { return gray * 0x010101U; });
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const std::uint8_t* const rgba = color.rgba.data() + 4 * (std::size_t(y) * color.width + x);
      if (rgba[3] == 0) continue;
      pixels[std::size_t(color.row + y) * image.width + color.column + x] = rgba[0] << 16U | rgba[1] << 8U | rgba[2];
    }
  cairo_surface_t* source = cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_RGB24, image.width, image.height, 4 * image.width);
  cairo_t* cairo = state_->cairo;
  cairo_save(cairo);
  cairo_rectangle(cairo, box.left, box.top, box.width, box.height);
  cairo_clip(cairo);
  cairo_translate(cairo, box.left, box.top);
  cairo_scale(cairo, box.width / image.width, box.height / image.height);
  cairo_set_source_surface(cairo, source, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
  cairo_pattern_set_extend(cairo_get_source(cairo), CAIRO_EXTEND_PAD);
  cairo_paint(cairo);
  cairo_restore(cairo);
  cairo_surface_destroy(source);
}

double Canvas::text(double x, double y, const std::string& text, const TextStyle& style, double max_px) {
  cairo_t* cairo = state_->cairo;
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size_px);
  cairo_text_extents_t size;
  cairo_text_extents(cairo, text.c_str(), &size);
  if (size.x_advance > max_px) {
    cairo_set_font_size(cairo, style.size_px * max_px / size.x_advance);
    cairo_text_extents(cairo, text.c_str(), &size);
  }
  const double left = style.align == Align::Left     ? x
                      : style.align == Align::Center ? x - size.x_advance / 2
                                                     : x - size.x_advance;
  state_->use(style.ink);
  cairo_move_to(cairo, left, y);
  cairo_show_text(cairo, text.c_str());
  return size.x_advance;
}

void Canvas::copyTo(VideoFrame& frame) const {
  cairo_surface_flush(state_->surface);
  frame.width = cairo_image_surface_get_width(state_->surface);
  frame.height = cairo_image_surface_get_height(state_->surface);
  frame.channels = 3;
  frame.pixels.resize(std::size_t(frame.width) * frame.height * 3);
  const unsigned char* rows = cairo_image_surface_get_data(state_->surface);
  const int stride = cairo_image_surface_get_stride(state_->surface);
  std::uint8_t* out = frame.pixels.data();
  for (int y = 0; y < frame.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(rows + std::ptrdiff_t(y) * stride);
    for (int x = 0; x < frame.width; ++x, out += 3) {
      out[0] = static_cast<std::uint8_t>(row[x] >> 16);
      out[1] = static_cast<std::uint8_t>(row[x] >> 8);
      out[2] = static_cast<std::uint8_t>(row[x]);
    }
  }
}

}  // namespace insonate::video
