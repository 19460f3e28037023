#include "server/MadeUpWorkstation.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/site/HttpLink.h>
#include <insonate/teaching/AttemptFactsOf.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <random>
#include <thread>

namespace insonate::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kTick_s = 1e-3, kWaiting_s = 2, kSpeed_mmps = 5;
/// Time from the end of an attempt until it is stored.
constexpr std::int64_t kPause_us = 2'000'000;
constexpr double kAbove_mm = 10, kVein_mm = 20, kTarget_mm = 25;

/// Hands that hold the probe still and advance the needle into a vein 20 mm deep, with tremor and the noise of a
/// device.
class MadeUpHands {
 public:
  explicit MadeUpHands(unsigned seed) : random_(seed), phase_rad_(std::uniform_real_distribution(0.0, 6.0)(random_)) {}

  double depthAt_mm(double time_s) const {
    return std::min(kTarget_mm, std::max(0.0, time_s - kWaiting_s) * kSpeed_mmps - kAbove_mm);
  }
  AttemptSample at(double time_s) {
    constexpr double kTremor_mm = 0.15, kTremor_Hz = 9;
    const double tremor_mm = kTremor_mm * std::sin(2 * std::numbers::pi * kTremor_Hz * time_s + phase_rad_);
    const Vec3 axis = normalized({1, 0, 1}), side{0, 1, 0};
    AttemptSample sample;
    sample.time_us = std::llround(time_s * 1e6);
    sample.patientFromProbe = Transform{{}, {20 + noise_mm(random_), noise_mm(random_) + tremor_mm, 0}};
    const Vec3 tip_mm = axis * depthAt_mm(time_s) + Vec3{noise_mm(random_), tremor_mm, noise_mm(random_)};
    sample.patientFromNeedle = Transform{{{cross(side, axis), side, axis}}, tip_mm};
    if (depthAt_mm(time_s) > 0) sample.needleDepth_mm = depthAt_mm(time_s);
    sample.probeForce_N = 2 + noise_mm(random_);
    sample.imageDepth_mm = 40;
    sample.aspirating = true;
    return sample;
  }

 private:
  std::mt19937 random_;
  const double phase_rad_;
  std::normal_distribution<double> noise_mm{0, 0.01};
};

std::string freshId() {
  std::random_device random;
  const auto bits = [&](std::uint32_t mask) { return random() & mask; };
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%08x-%04x-4%03x-8%03x-%06x%06x", bits(0xFFFFFFFF), bits(0xFFFF), bits(0xFFF),
                bits(0xFFF), bits(0xFFFFFF), bits(0xFFFFFF));
  return text.data();
}

/// Time as AttemptHeader::begun states it.
std::string isoTime(std::int64_t time_us) {
  const std::time_t time_s = time_us / 1'000'000;
  std::tm utc{};
  ::gmtime_r(&time_s, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

AttemptEvent punctureOf(Label wall, Label into, double depth_mm, double time_s) {
  const Vec3 axis = normalized({1, 0, 1});
  AttemptEvent event{
      .time_us = std::llround(time_s * 1e6), .kind = AttemptEventKind::Entered, .wall = wall, .into = into};
  event.tip_mm = axis * depth_mm, event.axis = axis, event.depth_mm = depth_mm;
  if (wall == kSkin) event.outward = Vec3{0, 0, -1};
  return event;
}

Result<void> record(const fs::path& file, const AttemptHeader& header, const RecordKey& key, double duration_s,
                    unsigned seed) {
  const auto recorder = AttemptRecorder::start(file, header, nullptr, key);
  if (!recorder) return tl::unexpected(recorder.error());
  MadeUpHands hands(seed);
  const auto put = [&](const auto& what) {
    while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    (*recorder)->record(what);
  };
  const auto ticks = std::llround(duration_s / kTick_s);
  for (std::int64_t i = 1; i <= ticks; ++i) {
    const double before_s = static_cast<double>(i - 1) * kTick_s, now_s = static_cast<double>(i) * kTick_s;
    put(hands.at(now_s));
    const auto crosses = [&](double depth_mm) {
      return hands.depthAt_mm(before_s) < depth_mm && hands.depthAt_mm(now_s) >= depth_mm;
    };
    if (crosses(0)) put(punctureOf(kSkin, kFat, 0, now_s));
    if (crosses(kVein_mm)) put(punctureOf(kVein, kVein, kVein_mm, now_s));
  }
  const auto finished = (*recorder)->finish(AttemptStatus::Completed);
  return finished ? Result<void>() : tl::unexpected(finished.error());
}

}  // namespace

Result<CurriculumStore> MadeUpWorkstation::open() const {
  StoreServices services;
  services.workstation = name_;
  services.passwordCost = PasswordCost::Minimum;
  return CurriculumStore::open((folder_ / "workstation.db").string(), services);
}

Result<void> MadeUpWorkstation::prepare(const std::string& url, const std::string& token, const std::string& trainee,
                                        const Curriculum& curriculum, double duration_s, unsigned seed) {
  std::error_code failed;
  if (fs::create_directories(folder_, failed); failed) return fail(folder_.string() + ": " + failed.message() + ".");
  const auto store = open();
  if (!store) return tl::unexpected(store.error());
  const auto link = httpLink({.url = url, .token = token, .authority = {}});
  if (!link) return tl::unexpected(link.error());
  const SiteUpload site(*store, *link);
  if (const auto known = site.signIn(trainee, kMadeUpPassword); !known) return tl::unexpected(known.error());
  const auto by = store->signIn(trainee, kMadeUpPassword);
  if (!by) return tl::unexpected(by.error());

  const Level& level = curriculum.levels.front();
  const auto procedure = builtInProcedure(level.procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  AttemptFacts begun{.id = freshId(), .person = by->person().id, .curriculum = curriculum.name};
  begun.curriculumVersion = curriculum.version, begun.level = level.name;
  const auto seal = AttemptStore(*by).issueSeal(begun);
  if (!seal) return tl::unexpected(seal.error());
  AttemptHeader header{.software = "insonate bench",
                       .begun = isoTime(by->now_us() - std::llround(1e6 * duration_s) - kPause_us),
                       .procedure = level.procedure};
  header.procedureVersion = procedure->version, header.caseName = "Textbook neck", header.caseHash = "c0ffee";
  header.picture = {.width_mm = 38, .sliceHalf_mm = 1.5};
  header.recordedFor = {begun.id, begun.person, begun.curriculum, begun.curriculumVersion, begun.level, seal->nonce};
  const fs::path file = folder_ / "new.attempt";
  if (auto made = record(file, header, seal->key, duration_s, seed); !made) return made;
  auto facts = factsOfRecording(file);
  if (!facts) return tl::unexpected(facts.error());
  facts->proof = AttemptProof::Proven;
  if (const auto kept = AttemptStore(*by).add(*facts, file); !kept) return tl::unexpected(kept.error());
  fs::remove(file, failed);
  facts_ = std::move(*facts);
  return {};
}

fs::path MadeUpWorkstation::recording() const {
  return folder_ / "workstation.db.recordings" / (facts_.id + ".attempt");
}

Result<double> MadeUpWorkstation::send(const std::string& url, const std::string& token) const {
  const auto store = open();
  if (!store) return tl::unexpected(store.error());
  const auto link = httpLink({.url = url, .token = token, .authority = {}});
  if (!link) return tl::unexpected(link.error());
  const SiteUpload site(*store, *link);
  const auto begun = std::chrono::steady_clock::now();
  const auto report = site.exchange();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begun;
  if (!report) return tl::unexpected(report.error());
  if (!report->errors.empty()) return fail(report->errors.front());
  const auto pending = site.pending();
  if (!pending) return tl::unexpected(pending.error());
  if (*pending > 0) return fail("The server has not acknowledged the attempt.");
  return time.count();
}

}  // namespace insonate::bench
