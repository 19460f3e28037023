#include <insonate/procedure/AttemptEvent.h>

namespace insonate {
namespace {

/// In the order of AttemptEventKind.
constexpr std::array<std::string_view, kAttemptEventKinds> kKindNames{"entered",
                                                                      "left",
                                                                      "withdrawn",
                                                                      "struck",
                                                                      "needle replaced",
                                                                      "frozen",
                                                                      "released",
                                                                      "positioned",
                                                                      "centered",
                                                                      "compressed",
                                                                      "performed",
                                                                      "wire in short axis",
                                                                      "wire in long axis",
                                                                      "instrument entered",
                                                                      "instrument removed",
                                                                      "instrument stopped",
                                                                      "wire lost",
                                                                      "air entered",
                                                                      "ectopy",
                                                                      "color shown",
                                                                      "wire kinked",
                                                                      "tachycardia",
                                                                      "bubbles seen",
                                                                      "pneumothorax"};
/// In the order of LineAct.
constexpr std::array<std::string_view, kLineActs> kActNames{
    "check consent",  "time-out",         "cover probe",       "anesthetize",       "detach syringe",
    "attach syringe", "cover hub",        "uncover hub",       "hold wire",         "release wire",
    "nick skin",      "measure pressure", "flush for bubbles", "trust blood color", "aspirate lumen",
    "flush lumen",    "secure catheter",  "apply dressing",    "check lung sliding"};
/// In the order of Instrument.
constexpr std::array<std::string_view, kInstruments> kInstrumentNames{"needle", "wire", "dilator", "catheter"};

}  // namespace

std::string_view nameOf(AttemptEventKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)];
}

const std::array<std::string_view, kAttemptEventKinds>& attemptEventNames() {
  return kKindNames;
}

std::string_view nameOf(LineAct act) {
  return kActNames[static_cast<std::size_t>(act)];
}

const std::array<std::string_view, kLineActs>& lineActNames() {
  return kActNames;
}

const std::array<std::string_view, kInstruments>& instrumentNames() {
  return kInstrumentNames;
}

std::string_view nameOf(Instrument instrument) {
  return kInstrumentNames[static_cast<std::size_t>(instrument)];
}

}  // namespace insonate
