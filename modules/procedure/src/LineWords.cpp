#include "LineWords.h"

#include <array>
#include <cstdio>

namespace insonate {
namespace {

std::string amountText(double amount, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, amount);
  return text.data();
}

std::string actSentence(const AttemptEvent& event, const std::string& vessel) {
  switch (event.act) {
    case LineAct::CheckConsent:
      return "Indication and consent are checked.";
    case LineAct::TimeOut:
      return "The time-out is done.";
    case LineAct::CoverProbe:
      return "The probe has a sterile cover, and the patient is draped.";
    case LineAct::Anesthetize:
      return "The site has local anesthetic.";
    case LineAct::DetachSyringe:
      return "The syringe is off the needle.";
    case LineAct::AttachSyringe:
      return "The syringe is on the needle.";
    case LineAct::CoverHub:
      return "A finger covers the hub.";
    case LineAct::UncoverHub:
      return "The hub is uncovered.";
    case LineAct::HoldWire:
      return "The hand holds the wire.";
    case LineAct::ReleaseWire:
      return "The hand has let go of the wire.";
    case LineAct::NickSkin:
      return "The skin is nicked.";
    case LineAct::MeasurePressure:
      return "The pressure is measured in " + vessel + ": " + amountText(event.amount, "%.0f mmHg.");
    case LineAct::FlushForBubbles:
      return "Saline is flushed into " + vessel + ".";
    case LineAct::TrustBloodColor:
      return "The color of the blood is taken as proof of the vein.";
    case LineAct::AspirateLumen:
      return "Lumen " + amountText(event.amount, "%.0f") + " is aspirated.";
    case LineAct::FlushLumen:
      return "Lumen " + amountText(event.amount, "%.0f") + " is flushed and clamped.";
    case LineAct::SecureCatheter:
      return "The catheter is fixed.";
    case LineAct::ApplyDressing:
      return "The site has a sterile dressing.";
    case LineAct::CheckLungSliding:
      break;
  }
  return event.amount > 0 ? "The lung of this side was checked: it does not slide."
                          : "The lung of this side was checked.";
}

}  // namespace

std::string lineSentence(const AttemptEvent& event, const std::string& vessel) {
  const std::string tool = "The " + std::string(nameOf(event.instrument));
  switch (event.kind) {
    case AttemptEventKind::Performed:
      return actSentence(event, vessel);
    case AttemptEventKind::WireInShortAxis:
      return "The image shows the wire in " + vessel + ", in short axis.";
    case AttemptEventKind::WireInLongAxis:
      return "The image shows the wire in " + vessel + ", in long axis.";
    case AttemptEventKind::BubblesSeen:
      return "The image shows the bubbles of the flush into " + vessel + ".";
    case AttemptEventKind::InstrumentEntered:
      return tool + " is in " + vessel + ".";
    case AttemptEventKind::InstrumentRemoved:
      return tool + " is out of the skin.";
    case AttemptEventKind::InstrumentStopped:
      return tool + " meets a resistance and stops.";
    case AttemptEventKind::WireLost:
      return "The whole wire is in the body.";
    case AttemptEventKind::WireKinked:
      return "The wire has a kink.";
    case AttemptEventKind::Pneumothorax:
      return "The needle has punctured the pleura: a pneumothorax.";
    case AttemptEventKind::Tachycardia:
      return "The wire is through the right atrium: a run of tachycardia.";
    case AttemptEventKind::AirEntered:
      return "Air was sucked into the vein: " + amountText(event.amount, "%.1f ml.");
    default:
      return "The wire touches the heart: extra beats.";
  }
}

}  // namespace insonate
