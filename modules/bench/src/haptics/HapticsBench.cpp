#include <insonate/bench/HapticsBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/haptics/ServoThread.h>
#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>

#include <chrono>
#include <thread>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr std::uint64_t kNeckSeed = 1;
constexpr int kProfile = 1;  // Desktop
constexpr double kPassiveSpeed_mmps = 100;

/// Images of the built-in neck, one after the other, on a thread of their own.
class Pictures {
 public:
  static Result<std::unique_ptr<Pictures>> make(const Progress& progress) {
    auto patient = makePhantom(phantomVariants().front().name, kNeckSeed, progress);
    if (!patient) return tl::unexpected(patient.error());
    auto probe = loadProbe("linear");
    auto tissues = loadAcousticTable("neck");
    const auto start = autoStartPose(*patient);
    if (!probe) return tl::unexpected(probe.error());
    if (!tissues) return tl::unexpected(tissues.error());
    if (!start) return tl::unexpected(start.error());
    ImagingSetup setup{
        .probe = *probe, .settings = settingsFor(*probe), .tissues = std::move(*tissues), .engine = "cpu"};
    const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
    if (!pose) return tl::unexpected(pose.error());
    auto scene = makeScene(*patient, setup, sceneRegion(setup, *pose), progress);
    if (!scene) return tl::unexpected(scene.error());
    auto imager = Imager::make(setup);
    if (!imager) return tl::unexpected(imager.error());
    return std::unique_ptr<Pictures>(new Pictures(std::move(*scene), std::move(*imager), *pose));
  }
  int count() const { return count_; }

 private:
  Pictures(std::shared_ptr<const AcousticScene> scene, Imager imager, const Transform& pose)
      : scene_(std::move(scene)), imager_(std::move(imager)), thread_([this, pose](const std::stop_token& stop) {
          ImagingFrame frame;
          while (!stop.stop_requested()) {
            imager_.render(*scene_, pose, frame);
            ++count_;
          }
        }) {}

  std::shared_ptr<const AcousticScene> scene_;
  Imager imager_;
  std::atomic<int> count_ = 0;
  std::jthread thread_;  // the last member, since the thread uses the others
};

HandPath pathOf(std::initializer_list<std::pair<double, Vec3>> points) {
  HandPath path;
  for (const auto& [time_s, position_mm] : points) path.points.push_back({time_s, position_mm, {}});
  return path;
}

LocalModel flatSkin(const std::shared_ptr<const TissueGrid>& grid) {
  LocalModel model;
  model.time_ns = std::chrono::nanoseconds(WallClock::now().time_since_epoch()).count();
  model.grid = grid;
  model.patchCount = 3;
  for (int i = 0; i < 3; ++i) model.patches[i] = {{(i - 1) * 15.0, 0, 0}, {}, {0, 0, -1}, 0.1, 0.01};
  return model;
}

Result<HapticsBenchRow> runServo(const std::string& scenario, double seconds, const Progress& progress,
                                 std::string& rights) {
  const DeviceProfile& profile = deviceProfiles()[kProfile];
  const Vec3 probeAt{-70, 0, -10}, needleAt{0, 0, -10};
  const auto probe = std::make_shared<SimulatedDevice>("probe", profile, Grip{}, HandPath::Point{0, probeAt, {}});
  const auto needle = std::make_shared<SimulatedDevice>("needle", profile, Grip{}, HandPath::Point{0, needleAt, {}});
  const auto table = loadNeedleTable("measured");
  if (!table) return tl::unexpected(table.error());
  ServoSetup setup;
  setup.needle = *table;
  for (ToolSetup& hand : setup.tools) hand.limits = profile.limits;
  const auto grid = layeredPhantom();
  ServoThread servo;
  servo.configure(setup);
  servo.setLocalModel(flatSkin(grid));
  servo.assignDevice(kProbeTool, probe);
  servo.assignDevice(kNeedleTool, needle);
  probe->follow(pathOf({{0, probeAt}, {0.5, {-70, 0, 7}}, {1, {-65, 3, 7}}, {1.5, probeAt}}));
  needle->follow(pathOf({{0, needleAt}, {1, {0, 0, 26}}, {1.2, {0, 0, 24}}, {2, needleAt}}));
  std::this_thread::sleep_for(200ms);
  servo.clearTiming();
  const auto begin = WallClock::now();
  for (double gone_s = 0; gone_s < seconds; gone_s = std::chrono::duration<double>(WallClock::now() - begin).count()) {
    if (!report(progress, "Running the servo", gone_s / seconds)) return fail(std::string(kCancelled));
    servo.setLocalModel(flatSkin(grid));
    std::this_thread::sleep_for(15ms);
  }
  const TickTiming timing = servo.tickTiming();
  rights = servo.realTimeRights().sentence;
  return HapticsBenchRow{.scenario = scenario,
                         .ticks = timing.ticks,
                         .lateTicks = timing.late,
                         .p50_us = timing.p50_us,
                         .p99_us = timing.p99_us,
                         .p999_us = timing.p999_us,
                         .max_us = timing.max_us,
                         .wakeP99_us = timing.wakeP99_us,
                         .wakeMax_us = timing.wakeMax_us,
                         .pictures = 0,
                         .passivityMin_J = std::min(probe->minEnergy_J(), needle->minEnergy_J())};
}

StiffnessRow stiffnessOf(const std::string& name, const DeviceLimits& device, const Grip& grip) {
  return {name, device.maxStiffness_Npmm, passiveStiffness_Npmm(device, 0, kPassiveSpeed_mmps),
          maxStableStiffness_Npmm(device, grip, false), maxStableStiffness_Npmm(device, grip, true)};
}

void addStiffness(HapticsBench& bench) {
  for (const DeviceProfile& profile : deviceProfiles())
    bench.stiffness.push_back(stiffnessOf(std::string(profile.name), profile.limits, {}));
  DeviceLimits free;
  free.maxForce_N = 1e9, free.rate_Hz = 1000, free.mass_kg = 0.2, free.damping_Nspm = 0.2;
  bench.colgate = stiffnessOf("free, 0.2 N s/m", free, {0, 0, 0});
}

Result<void> addCurves(HapticsBench& bench) {
  for (const std::string& name : needlePresetNames()) {
    const auto table = loadNeedleTable(name);
    if (!table) return tl::unexpected(table.error());
    bench.curves.push_back({name, needleForceCurve(*table, 5, 2, 41.5)});
  }
  return {};
}

}  // namespace

Result<HapticsBench> runHapticsBench(bool quick, const Progress& progress) {
  HapticsBench bench;
  if (auto ok = addCurves(bench); !ok) return tl::unexpected(ok.error());
  if (!report(progress, "Searching stable stiffness", 0)) return fail(std::string(kCancelled));
  addStiffness(bench);
  const double seconds = quick ? 2 : 30;
  std::string rights;
  const auto idle = runServo("idle", seconds, progress, rights);
  if (!idle) return tl::unexpected(idle.error());
  bench.rows.push_back(*idle);
  const auto pictures = Pictures::make(progress);
  if (!pictures) return tl::unexpected(pictures.error());
  const int before = (*pictures)->count();
  auto rendering = runServo("rendering", seconds, progress, rights);
  if (!rendering) return tl::unexpected(rendering.error());
  rendering->pictures = (*pictures)->count() - before;
  bench.rows.push_back(*rendering);
  bench.notes = {
      rights,
      "Two simulated hands (Desktop): one presses and slides on skin, one pushes a needle through skin and a vein and "
      "back. "
      "A tick takes both states, works out both forces and hands them over.",
      "`rendering`: the cpu engine makes images of the built-in neck on all processors meanwhile, without a pause.",
      "Late ticks began more than a millisecond after their time; waking up is the system's part, the work of a tick "
      "ours.",
      "Stiffness of a wall, N/mm, by search in steps of 7 %. The bound is that up to which the device makes up for "
      "what a "
      "sampled wall gives, by damping (Colgate) or by friction, at 100 mm/s; a hand, which damps with 5 N s/m, stands "
      "more.",
      "Forces: an 18 G needle at 5 mm/s through skin (0 to 2 mm), fat (to 10), muscle, a vein (18 to 28), muscle and "
      "onto "
      "bone (40), by a machine that does not give way, on a device that shows 2 N/mm."};
  return bench;
}

}  // namespace insonate
