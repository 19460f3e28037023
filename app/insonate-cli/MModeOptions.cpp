#include "MModeOptions.h"

#include "Interrupt.h"

#include <insonate/core/Progress.h>
#include <insonate/simulator/ImageFiles.h>
#include <insonate/ultrasound/MMode.h>

#include <cmath>
#include <vector>

namespace insonate::cli {
namespace {

constexpr double kColumn_s = 0.02;
constexpr int kRows = 480, kPixelsPerColumn = 4;

}  // namespace

void MModeOptions::addTo(CLI::App& command, std::string& file) {
  CLI::Option* wanted = command.add_option(
      "--mmode", file,
      "PNG to write, with M-mode: one scanline of the image over time, depth increases downward, time to the right");
  command.add_option("--line", line, "Scanline of --mmode, as a fraction of the field of view from its left edge")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0))
      ->needs(wanted);
  command.add_option("--seconds", seconds, "Duration of --mmode, s, from --time on")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 60.0))
      ->needs(wanted);
}

Result<void> writeMMode(const MModeOptions& options, const ImagingSetup& setup, const AcousticScene& scene,
                        Presser& presser, double start_s, std::uint32_t noiseSeed, const std::string& file) {
  ImagingSetup still = setup;
  still.settings.persistence = 0;
  still.color.reset();
  auto imager = Imager::make(still);
  if (!imager) return tl::unexpected(imager.error());
  const auto columns = std::max<long>(1, std::lround(options.seconds / kColumn_s));
  BModeImage strip;
  strip.width = static_cast<int>(columns) * kPixelsPerColumn, strip.height = kRows;
  strip.pixel_mm = setup.settings.depth_mm / kRows;
  strip.gray.resize(std::size_t(strip.width) * kRows);
  ImagingFrame frame;
  std::vector<std::uint8_t> gray(kRows);
  const Transform pose = presser.pose();
  for (long column = 0; column < columns; ++column) {
    if (interruptSignal() != 0) return fail(std::string(kCancelled));
    presser.holdAt(scene, pose, start_s + double(column) * kColumn_s);
    frame.noiseSeed = noiseSeed + static_cast<std::uint32_t>(column);
    imager->render(scene, pose, presser.displacement(), {}, frame);
    lineOverTime(frame.image, still.probe, still.settings, options.line, gray);
    for (int row = 0; row < kRows; ++row)
      std::fill_n(strip.gray.begin() + std::ptrdiff_t(row) * strip.width + column * kPixelsPerColumn, kPixelsPerColumn,
                  gray[std::size_t(row)]);
  }
  return writePng(strip, file);
}

}  // namespace insonate::cli
