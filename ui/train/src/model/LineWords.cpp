#include "LineWords.h"

#include <QCoreApplication>

namespace insonate::train {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(LineWords)
};

}  // namespace

QString titleOf(LineAct act, int lumen) {
  switch (act) {
    case LineAct::CheckConsent:
      return Words::tr("Check indication and consent");
    case LineAct::TimeOut:
      return Words::tr("Do the time-out");
    case LineAct::CoverProbe:
      return Words::tr("Cover probe and patient");
    case LineAct::Anesthetize:
      return Words::tr("Give local anesthetic");
    case LineAct::DetachSyringe:
      return Words::tr("Detach syringe");
    case LineAct::AttachSyringe:
      return Words::tr("Attach syringe");
    case LineAct::CoverHub:
      return Words::tr("Cover hub with a finger");
    case LineAct::UncoverHub:
      return Words::tr("Uncover hub");
    case LineAct::HoldWire:
      return Words::tr("Hold wire");
    case LineAct::ReleaseWire:
      return Words::tr("Release wire");
    case LineAct::NickSkin:
      return Words::tr("Nick skin");
    case LineAct::MeasurePressure:
      return Words::tr("Measure pressure");
    case LineAct::FlushForBubbles:
      return Words::tr("Flush saline and look for bubbles");
    case LineAct::TrustBloodColor:
      return Words::tr("Accept blood color as proof of the vein");
    case LineAct::AspirateLumen:
      return Words::tr("Aspirate lumen %1").arg(lumen);
    case LineAct::FlushLumen:
      return Words::tr("Flush and clamp lumen %1").arg(lumen);
    case LineAct::SecureCatheter:
      return Words::tr("Fix catheter");
    case LineAct::ApplyDressing:
      return Words::tr("Apply dressing");
    case LineAct::CheckLungSliding:
      break;
  }
  return Words::tr("Check lung sliding");
}

QString titleOf(Instrument instrument) {
  switch (instrument) {
    case Instrument::Needle:
      return Words::tr("Needle");
    case Instrument::Wire:
      return Words::tr("Wire");
    case Instrument::Dilator:
      return Words::tr("Dilator");
    case Instrument::Catheter:
      break;
  }
  return Words::tr("Catheter");
}

}  // namespace insonate::train
