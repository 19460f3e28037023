#include "Commands.h"
#include "RodFile.h"

#include <insonate/tissue/Labels.h>
#include <insonate/wire/WireSolver.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>

namespace insonate::cli {
namespace {

struct WireOptions {
  std::string caseFolder, wire = "j-tip", file;
  std::vector<double> tip_mm, direction, bevel;
  double angle_deg = 40, roll_deg = 0, length_mm = 180;
  bool json = false;
};

constexpr double kMaxLength_mm = 1000, kReport_mm = 10;

std::optional<Vec3> vectorOf(const std::vector<double>& v) {
  if (v.size() != 3) return std::nullopt;
  return Vec3{v[0], v[1], v[2]};
}

/// A needle in the first target of the case, from the front and toward the heart.
Result<WireEntry> usualEntry(const CaseManifest& manifest, const VesselTree& tree, double angle_deg) {
  if (manifest.targets.empty())
    return fail("The case has no target into which a needle could point. Give --needle, a point in a vessel.");
  const Target& target = manifest.targets.front();
  Vec3 along = tree.locate(target.label, target.position_mm).towardHeart;
  if (!(norm(along) > 0)) along = {0, 0, -1};
  Vec3 inward = Vec3{0, 1, 0} - along * along.y;
  inward = normalized(inward);
  const double angle = angle_deg * std::numbers::pi / 180;
  return WireEntry{target.position_mm, along * std::cos(angle) + inward * std::sin(angle), -inward, 0};
}

Result<WireEntry> entryOf(const WireOptions& options, const CaseManifest& manifest, const VesselTree& tree) {
  Result<WireEntry> entry = WireEntry{};
  if (const auto tip_mm = vectorOf(options.tip_mm)) {
    entry->tip_mm = *tip_mm;
    const auto direction = vectorOf(options.direction);
    if (!direction || !(norm(*direction) > 0)) return fail("--direction needs three numbers that are not all 0.");
    entry->direction = normalized(*direction);
    entry->bevelNormal = std::abs(entry->direction.y) > 0.99 ? Vec3{0, 0, -1} : Vec3{0, -1, 0};
  } else {
    entry = usualEntry(manifest, tree, options.angle_deg);
    if (!entry) return entry;
  }
  if (const auto bevel = vectorOf(options.bevel)) entry->bevelNormal = *bevel;
  if (norm(cross(entry->bevelNormal, entry->direction)) < 1e-3)
    return fail("--bevel points along the needle. Give a direction across the shaft.");
  entry->roll_deg = options.roll_deg;
  return entry;
}

std::string placeOf(const WireState& state, const VesselTree& tree) {
  if (state.tip == WireTip::InNeedle) return "needle";
  if (state.tip == WireTip::Tissue || state.at.vessel < 0) return "tissue";
  return tree.vessels()[state.at.vessel].tube.name;
}

nlohmann::json jsonOf(const WireState& state, const VesselTree& tree) {
  nlohmann::json json{{"inserted_mm", state.inserted_mm},
                      {"resistance_N", state.resistance_N},
                      {"tip_in", placeOf(state, tree)},
                      {"along_mm", state.at.along_mm},
                      {"smallest_bend_radius_mm", 1 / std::max(state.maxCurvature_1pmm, 1e-4)},
                      {"refusal", nameOf(state.refusal)}};
  if (std::isfinite(state.at.toHeart_mm)) json["to_heart_mm"] = state.at.toHeart_mm;
  return json;
}

void print(const WireState& state, const VesselTree& tree) {
  std::printf("%5.0f mm  %5.2f N  ", state.inserted_mm, state.resistance_N);
  if (std::isfinite(state.at.toHeart_mm)) std::printf("%5.0f mm to the heart  ", state.at.toHeart_mm);
  std::printf("%s%s%s\n", placeOf(state, tree).c_str(), state.refusal == WireRefusal::None ? "" : ": ",
              std::string(nameOf(state.refusal)).c_str());
}

Result<void> feedWire(const WireOptions& options) {
  if (!(options.length_mm > 0 && options.length_mm <= kMaxLength_mm)) return fail("--length must be 0 to 1000 mm.");
  auto wire = loadWire(options.wire);
  if (!wire) return tl::unexpected(wire.error());
  const auto read = readCase(options.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  const auto tree = VesselTree::make(read->patient.manifest.vessels, &read->patient.labels);
  if (!tree) return tl::unexpected(tree.error());
  const auto entry = entryOf(options, read->patient.manifest, *tree);
  if (!entry) return tl::unexpected(entry.error());
  WireSolver solver(*tree, std::move(*wire));
  solver.start(*entry);
  nlohmann::json steps = nlohmann::json::array();
  while (solver.state().inserted_mm < options.length_mm - 1e-9 && solver.state().refusal == WireRefusal::None) {
    solver.advance(std::min(kReport_mm, options.length_mm - solver.state().inserted_mm));
    steps.push_back(jsonOf(solver.state(), *tree));
    if (!options.json) print(solver.state(), *tree);
  }
  if (!options.file.empty())
    if (auto ok = writeRod(solver.wire(), solver.nodes_mm(), options.file); !ok) return ok;
  if (!options.json) return {};
  nlohmann::json object = jsonOf(solver.state(), *tree);
  object["wire"] = solver.wire().name;
  object["needle"] = {{"tip_mm", jsonArray(entry->tip_mm)}, {"direction", jsonArray(entry->direction)}};
  object["steps"] = steps;
  nlohmann::json nodes = nlohmann::json::array();
  for (const Vec3& node : solver.nodes_mm()) nodes.push_back(jsonArray(node));
  object["nodes_mm"] = nodes;
  printJson(object);
  return {};
}

}  // namespace

void addWireCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("wire", "Advance a guidewire or catheter through a needle into the vessels");
  auto o = std::make_shared<WireOptions>();
  command->add_option("CASE", o->caseFolder, "Folder of the case")->required()->check(notEmpty());
  const auto vector = [&](const char* name, std::vector<double>& values, const char* text) {
    return command->add_option(name, values, text)->expected(3)->delimiter(',');
  };
  auto* tip =
      vector("--needle", o->tip_mm, "Position of the needle tip, patient LPS, mm; by default the case's first target");
  auto* along = vector("--direction", o->direction, "Direction of the needle's shaft, toward the tip")->needs(tip);
  tip->needs(along);
  vector("--bevel", o->bevel, "Direction in which the bevel faces; by default to the front");
  command->add_option("--angle", o->angle_deg, "Angle between needle and vessel without --needle, degrees")
      ->capture_default_str()
      ->check(CLI::Range(5, 90))
      ->excludes(tip);
  command->add_option("--roll", o->roll_deg, "Angle about the shaft from the bevel to the bend of the J, degrees")
      ->capture_default_str()
      ->check(CLI::Range(-360, 360));
  command->add_option("--wire", o->wire, "Wire: j-tip, straight, dilator, triple-lumen, or a file")
      ->capture_default_str();
  command->add_option("--length", o->length_mm, "Length to advance beyond the needle, mm")->capture_default_str();
  command->add_option("--out", o->file, "File for the shape of the wire, which render --wire reads")->check(notEmpty());
  command->add_flag("--json", o->json, "Print one JSON object");
  command->callback([o, &outcome] {
    outcome.json = o->json;
    if (auto done = feedWire(*o); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
