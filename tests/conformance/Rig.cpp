#include "conformance/Rig.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace insonate::test {
namespace {

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

}  // namespace

AcousticTable plainTable() {
  AcousticTable table;
  for (AcousticTissue& tissue : table.tissues) tissue.attenuation_dBpcmMHz = 0;
  return table;
}

Probe probeNamed(const std::string& name) {
  return valueOf(loadProbe(name));
}

ImagingSettings silentSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes) {
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = scanlines, settings.samples = samples, settings.elevationPlanes = elevationPlanes;
  settings.looks = 1;
  settings.conformingContact = false;
  settings.effects = Effects::none();
  settings.effects.beam = true;
  return settings;
}

ImagingSettings speckleSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes) {
  ImagingSettings settings = silentSettings(probe, scanlines, samples, elevationPlanes);
  settings.effects.scattering = settings.effects.speckle = true;
  return settings;
}

ImagingSettings uniformSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes) {
  ImagingSettings settings = silentSettings(probe, scanlines, samples, elevationPlanes);
  settings.effects.scattering = true;
  return settings;
}

Region regionAround(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                    double margin_mm) {
  Region region = regionOf(probe, settings, patientFromProbe);
  const Vec3 margin{margin_mm, margin_mm, margin_mm};
  return {region.low_mm - margin, region.high_mm + margin};
}

VolumeGeometry alignedGridOver(const Region& region, double spacing_mm) {
  Vec3 low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = (std::floor(region.low_mm[a] / spacing_mm) - 1) * spacing_mm;
    high[a] = (std::ceil(region.high_mm[a] / spacing_mm) + 1) * spacing_mm;
  }
  return gridOver(low, high, spacing_mm);
}

ScenePtr sceneOf(const LabelPhantom& phantom, const AcousticTable& table, const Region& region,
                 std::vector<PointTarget> points) {
  return valueOf(AcousticScene::make(phantom.ct, phantom.labels, table, region, {}, std::move(points)));
}

ScenePtr evenScene(const Probe& probe, const ImagingSettings& settings, const AcousticTable& table,
                   const Transform& patientFromProbe, double margin_mm) {
  return sceneAround(
      probe, settings, 2.8, table, [](Vec3) { return kSoftTissue; }, patientFromProbe, margin_mm);
}

static EnvelopeFrame renderInstruments(const std::string& engineName, const Probe& probe,
                                       const ImagingSettings& settings, const AcousticScene& scene,
                                       const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                                       const Instruments& instruments) {
  if (auto ok = validate(settings, probe); !ok) throw std::runtime_error(ok.error().message);
  const auto engine = valueOf(makeEngine(engineName));
  EnvelopeFrame frame;
  engine->prepare(probe, settings);
  engine->render(scene, patientFromProbe, displacement, instruments, frame);
  if (engine->name() != engineName)
    throw std::runtime_error(std::string(engine->note()));  // another one has computed it
  return frame;
}

EnvelopeFrame renderWith(const std::string& engineName, const Probe& probe, const ImagingSettings& settings,
                         const AcousticScene& scene, const Transform& patientFromProbe,
                         const PlaneDisplacement& displacement, const std::optional<Needle>& needle) {
  if (needle)
    if (auto ok = validate(*needle); !ok) throw std::runtime_error(ok.error().message);
  return renderInstruments(engineName, probe, settings, scene, patientFromProbe, displacement,
                           needle ? &*needle : nullptr);
}

EnvelopeFrame renderWithRods(const std::string& engineName, const Probe& probe, const ImagingSettings& settings,
                             const AcousticScene& scene, const std::vector<FlexibleRod>& rods,
                             const PlaneDisplacement& displacement, const Needle* needle) {
  for (const FlexibleRod& rod : rods)
    if (auto ok = validate(rod); !ok) throw std::runtime_error(ok.error().message);
  return renderInstruments(engineName, probe, settings, scene, {}, displacement, {needle, rods});
}

EnvelopeFrame renderWithBubbles(const std::string& engine, const Probe& probe, const ImagingSettings& settings,
                                const AcousticScene& scene, const std::vector<Bubble>& bubbles,
                                const PlaneDisplacement& displacement) {
  return renderInstruments(engine, probe, settings, scene, {}, displacement, {nullptr, {}, bubbles});
}

Needle needleAt(Vec3 tip_mm, Vec3 direction, const Transform& patientFromProbe) {
  const Vec3 along = normalized(direction), up{0, 0, -1};
  const Vec3 bevel = norm(cross(along, up)) > 0.01 ? up : Vec3{1, 0, 0};
  Needle needle;
  needle.tip_mm = patientFromProbe * tip_mm;
  needle.direction = patientFromProbe.linear * along;
  needle.bevelNormal = patientFromProbe.linear * bevel;
  return needle;
}

Transform turned(Vec3 axis, double angle_deg, Vec3 about_mm) {
  const Vec3 n = normalized(axis);
  const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  Transform turn;
  for (int a = 0; a < 3; ++a) {
    const Vec3 e{a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
    turn.linear.column[a] = e * c + cross(n, e) * s + n * (dot(n, e) * (1 - c));  // Rodrigues
  }
  turn.offset = about_mm - turn.linear * about_mm;
  return turn;
}

Transform moved(Vec3 by_mm) {
  Transform move;
  move.offset = by_mm;
  return move;
}

void EngineTest::record(const std::string& what, double value) {
  RecordProperty(what, std::to_string(value));
}

std::string engineTestName(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace insonate::test
