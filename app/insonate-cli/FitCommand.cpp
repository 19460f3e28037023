#include "Commands.h"

#include <insonate/simulator/ImageFiles.h>
#include <insonate/ultrasound/FovFit.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

namespace insonate::cli {
namespace {

struct FitOptions {
  std::string picture, out, overlay, base, name;
  double depth_mm = 0, mmPerMark = 0;
  std::vector<double> points;  ///< x, y, x, y in pixels, and the mm between the two
  bool json = false;
};

/// The fit and the probe that was made from it.
struct FitReport {
  FovFit fit;
  double mm_per_px = 0;  ///< 0 where it is not known
  std::string scale;     ///< where it comes from
  std::string probe;     ///< the name of the probe that was written
};

void findScale(const FitOptions& options, FitReport& report) {
  if (options.depth_mm > 0) {
    report.mm_per_px = options.depth_mm / depthOf_px(report.fit.shape);
    report.scale = "the given depth";
  } else if (options.points.size() == 5) {
    const auto& p = options.points;
    report.mm_per_px = p[4] / std::hypot(p[2] - p[0], p[3] - p[1]);
    report.scale = "two points";
  } else if (const auto& ruler = report.fit.ruler) {
    const double mm = options.mmPerMark > 0 ? options.mmPerMark : ruler->mmPerMark;
    report.mm_per_px = mm / ruler->spacing_px;
    char text[128];
    std::snprintf(text, sizeof text, "%d marks of a depth scale, assumed to be %g mm apart", ruler->marks, mm);
    report.scale = text;
  }
}

Result<void> writeProbe(const FitOptions& options, FitReport& report) {
  if (report.mm_per_px <= 0)
    return fail(
        "The image shows no depth scale, so its size in millimeters is unknown. Give the displayed depth with "
        "--depth-mm.");
  const auto base = loadProbe(options.base.empty() ? nameOf(report.fit.shape.shape) : options.base);
  if (!base) return tl::unexpected(base.error());
  const std::string name = options.name.empty() ? std::filesystem::path(options.out).stem().string() : options.name;
  const auto probe = probeFromFit(report.fit.shape, report.mm_per_px, *base, name);
  if (!probe) return tl::unexpected(probe.error());
  report.probe = name;
  return saveProbe(*probe, options.out);
}

nlohmann::json jsonOf(const FitReport& report, const FitOptions& options) {
  const FovShape& shape = report.fit.shape;
  nlohmann::json object{{"shape", nameOf(shape.shape)},
                        {"origin_px", {shape.origin.x, shape.origin.y}},
                        {"rotation_deg", shape.rotation_deg},
                        {"upside_down", shape.upsideDown},
                        {"depth_px", depthOf_px(shape)},
                        {"confidence", report.fit.confidence},
                        {"doubts", report.fit.warnings},
                        {"ruler", nullptr},
                        {"mm_per_px", nullptr},
                        {"out", nullptr}};
  if (shape.shape == ProbeShape::Linear)
    object["width_px"] = shape.width_px;
  else
    object.update({{"alpha_deg", shape.alpha_deg}, {"r1_px", shape.r1_px}, {"r2_px", shape.r2_px}});
  if (const auto& ruler = report.fit.ruler)
    object["ruler"] = {{"spacing_px", ruler->spacing_px},
                       {"marks", ruler->marks},
                       {"long_every", ruler->longEvery},
                       {"mm_per_mark", ruler->mmPerMark}};
  if (report.mm_per_px > 0) object["mm_per_px"] = report.mm_per_px;
  if (!report.probe.empty()) object.update({{"out", options.out}, {"probe", report.probe}});
  return object;
}

void print(const FitReport& report, const FitOptions& options) {
  const FovShape& shape = report.fit.shape;
  if (shape.shape == ProbeShape::Linear)
    std::printf("linear: %.0f px wide, %.0f px deep", shape.width_px, shape.depth_px);
  else
    std::printf("%s: angle %.1f deg, r1 %.0f px, r2 %.0f px", nameOf(shape.shape).data(), shape.alpha_deg, shape.r1_px,
                shape.r2_px);
  std::printf("; turned by %.1f deg; confidence %.2f\n", shape.rotation_deg, report.fit.confidence);
  if (report.mm_per_px > 0)
    std::printf("depth %.1f mm, %.4f mm per pixel, from %s\n", depthOf_px(shape) * report.mm_per_px, report.mm_per_px,
                report.scale.c_str());
  if (!report.probe.empty()) std::printf("%s\n", options.out.c_str());
}

Result<FitReport> fitPicture(const FitOptions& options) {
  if (const auto& p = options.points; p.size() == 5 && (p[4] <= 0 || (p[0] == p[2] && p[1] == p[3])))
    return fail("--points needs two different points and a distance above 0.");
  const auto picture = readGrayImage(options.picture);
  if (!picture) return tl::unexpected(picture.error());
  auto fit = fitFov(*picture);
  if (!fit) return tl::unexpected(Error{options.picture + ": " + fit.error().message});
  FitReport report{std::move(*fit), 0, {}, {}};
  findScale(options, report);
  if (!options.overlay.empty())
    if (auto ok = writeFitImage(*picture, report.fit, options.overlay); !ok) return tl::unexpected(ok.error());
  if (!options.out.empty())
    if (auto ok = writeProbe(options, report); !ok) return tl::unexpected(ok.error());
  return report;
}

void fit(const FitOptions& options, Outcome& outcome) {
  outcome.json = options.json;
  const auto report = fitPicture(options);
  if (!report) return refuse(outcome, report.error());
  for (const std::string& doubt : report->fit.warnings) std::cerr << "insonate-cli: " << doubt << '\n';
  if (options.json) return printJson(jsonOf(*report, options));
  print(*report, options);
}

}  // namespace

void addFitCommand(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Fit a probe to a photograph or screen capture of a scanner's image");
  command->add_option("IMAGE", options->picture, "PNG or JPEG file")->required()->check(notEmpty());
  command->add_option("--out", options->out, "Probe file (JSON) to write, for render --probe")->check(notEmpty());
  command->add_option("--overlay", options->overlay, "PNG to write, with the image and the fitted outline")
      ->check(notEmpty());
  command
      ->add_option("--depth-mm", options->depth_mm, "Displayed depth in mm, from the middle of the face to the far end")
      ->check(CLI::Range(1.0, 400.0));
  command
      ->add_option("--points", options->points,
                   "Two points of the image in pixels, and their distance in mm: X Y X Y MM")
      ->expected(5)
      ->excludes("--depth-mm")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--mm-per-mark", options->mmPerMark,
                   "Distance between two marks of the depth scale in mm; estimated by default")
      ->check(CLI::Range(0.1, 100.0));
  command->add_option("--base", options->base,
                      "Probe from which to take the numbers that an image does not show; by default the built-in probe "
                      "of the same shape");
  command->add_option("--name", options->name, "Name of the probe; by default the name of the file");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->callback([options, &outcome] { fit(*options, outcome); });
}

}  // namespace insonate::cli
