#include "StepAct.h"

#include "../feature/CommandWords.h"
#include "../model/HapticControl.h"
#include "../model/LineWords.h"
#include "../model/LiveModel.h"

#include <insonate/haptics/SimulatedDevice.h>

#include <QCoreApplication>
#include <algorithm>
#include <variant>

namespace insonate::train {
namespace {

/// Finds the next act of one attempt at one moment.
class ActFinder {
  Q_DECLARE_TR_FUNCTIONS(ActFinder)

 public:
  ActFinder(const Procedure& procedure, const AttemptView& view, const HandsNow& hands, const ui::Commands& commands)
      : procedure_(procedure), view_(view), hands_(hands), commands_(commands) {}

  StepAct find() const {
    const ProcedureStep* step = view_.nextStep ? &procedure_.steps[*view_.nextStep] : nullptr;
    const auto* event = step ? std::get_if<EventCondition>(&step->until) : nullptr;
    const bool isFreezeDue = event && event->kind == AttemptEventKind::Frozen;
    // Probe and needle are held while the image is frozen.
    const bool isMisplaced = hands_.hasNeedle && view_.needle == NeedlePlace::WrongPlace && !view_.line.isWireIn();
    if (hands_.isFrozen && (isMisplaced || (step && !isFreezeDue)))
      return {tr("When you have seen enough, unfreeze the image: press %1, or click Unfreeze.")
                  .arg(key("train.image.freeze")),
              "freeze"};
    // Whatever is due, a needle in an artery or behind the vein does not stay there.
    if (isMisplaced) return withdraw();
    if (!step)
      return {tr("Finish: press %1, or click Finish.").arg(key("train.attempt.startOrFinish")), "attemptFinish"};
    if (!event) return holdingAct(std::get<StateCondition>(step->until));
    switch (event->kind) {
      case AttemptEventKind::Positioned:
        return {tr("Choose the position of the patient in the list above the button \"Aspirate\"."), "attemptPosition"};
      case AttemptEventKind::Centered:
        return slide();
      case AttemptEventKind::Compressed:
        return view_.isVeinCentered ? compress() : slide();
      case AttemptEventKind::ColorShown:
        return view_.isVeinCentered ? showColor() : slide();
      case AttemptEventKind::Frozen:
        return freeze();
      case AttemptEventKind::Withdrawn:
        return hands_.hasNeedle ? withdraw() : take();
      case AttemptEventKind::NeedleReplaced:
        return newNeedle();
      default:
        return towardWall(*event);
    }
  }

 private:
  /// One key of a command, in the words of the list of keys.
  QString key(const char* command, int index = 0) const {
    return keysOf(commands_, QLatin1String(command)).split(QStringLiteral(", ")).value(index);
  }

  /// Both keys of a command: "Alt+Q and Alt+E".
  QString keys(const char* command) const { return tr("%1 and %2").arg(key(command, 0), key(command, 1)); }

  StepAct holdingAct(const StateCondition& holding) const {
    switch (holding.what) {
      case StateCondition::What::ProbeOnSkin:
        return compress();
      case StateCondition::What::Performed:
        return perform(titleOf(holding.act));
      case StateCondition::What::SyringeOff:
        return perform(titleOf(LineAct::DetachSyringe));
      case StateCondition::What::VeinsSurveyed:
        return survey();
      case StateCondition::What::WireSeenInShortAxis:
        return showWire(tr("Show the wire in short axis: %1, until a bright dot is in the vein."));
      case StateCondition::What::WireSeenInLongAxis:
        return showWire(tr("Show the wire in long axis: %1, until a bright line of at least 10 mm lies in the vein."));
      case StateCondition::What::LumensFlushed:
        return flushLumens();
      case StateCondition::What::NeedleOffWire:
        return hands_.hasNeedle ? withdraw() : StepAct{};
      case StateCondition::What::SkinNicked:
        return perform(titleOf(LineAct::NickSkin));
      case StateCondition::What::WireInTarget:
        return insertWire();
      case StateCondition::What::VesselDilated:
        return moveInstrument(Instrument::Dilator, true);
      case StateCondition::What::DilatorRemoved:
        return moveInstrument(Instrument::Dilator, false);
      case StateCondition::What::CatheterInTarget:
        return moveInstrument(Instrument::Catheter, true);
      case StateCondition::What::CatheterWithoutWire:
        return moveInstrument(Instrument::Wire, false);
      case StateCondition::What::AspiratingInVein:
        break;
    }
    if (view_.line.isWireIn()) return moveInstrument(Instrument::Wire, true);
    if (!hands_.hasNeedle || view_.needle == NeedlePlace::Used || view_.needle == NeedlePlace::Clean)
      return towardWall({AttemptEventKind::Entered, kVein});
    if (!hands_.isAspirating) return aspirate();
    return view_.needle == NeedlePlace::Vein ? StepAct{tr("You are aspirating. Keep the needle tip in the vein."), {}}
                                             : advance();
  }

  StepAct towardWall(const EventCondition& event) const {
    if (view_.needle == NeedlePlace::Used) return newNeedle();
    // A needle cannot puncture a flat vein.
    if (view_.isVeinCompressed && view_.needle == NeedlePlace::Clean) return release();
    if (!hands_.hasNeedle) return take();
    if (hands_.angle_deg)
      for (const ProcedureRule& rule : procedure_.rules) {
        if (rule.limit.metric != Metric::InsertionAngle || !rule.limit.isBeyond(hands_.angle_deg)) continue;
        return rule.limit.under
                   ? StepAct{tr("Make the needle steeper: press %1, or hold down the button \"steeper\" under the "
                                "image.")
                                 .arg(key("train.needle.angle", 0)),
                             "needleSteeper"}
                   : StepAct{
                         tr("Make the needle flatter: press %1, or hold down the button \"flatter\" under the image.")
                             .arg(key("train.needle.angle", 1)),
                         "needleFlatter"};
      }
    if (view_.aim == NeedleAim::Beside || view_.aim == NeedleAim::Artery) return aimAtVein();
    const bool isUnderSkin = view_.needle == NeedlePlace::UnderSkin;
    if (event.wall != kSkin && isUnderSkin && !hands_.isAspirating) return aspirate();
    return advance();
  }

  StepAct perform(const QString& act) const {
    return {tr("Open the menu Acts under the image (%1), and choose \"%2\".").arg(key("train.line.acts"), act),
            "lineActs"};
  }
  StepAct flushLumens() const {
    const LineState& line = view_.line;
    for (int lumen = 1; lumen <= kCatheterLumens; ++lumen) {
      const auto index = static_cast<std::size_t>(lumen) - 1;
      if (line.isFlushed[index]) continue;
      return perform(titleOf(line.isAspirated[index] ? LineAct::FlushLumen : LineAct::AspirateLumen, lumen));
    }
    return {};
  }
  /// The wire needs a needle in the vein without a syringe. A wire that meets a resistance is not pushed on, since it
  /// would get a kink.
  StepAct insertWire() const {
    const LineState& line = view_.line;
    if (line.wireStop_mm > 0 && !line.isWireKinked) {
      StepAct back = moveInstrument(Instrument::Wire, false);
      back.words =
          tr("The wire meets a resistance; do not push it. Withdraw it by %1 mm: %2").arg(kBackOff_mm).arg(back.words);
      return back;
    }
    if (line.isWireIn()) return moveInstrument(Instrument::Wire, true);
    if (!hands_.hasNeedle || view_.needle != NeedlePlace::Vein) return towardWall({AttemptEventKind::Entered, kVein});
    return line.isSyringeOn ? perform(titleOf(LineAct::DetachSyringe)) : moveInstrument(Instrument::Wire, true);
  }
  StepAct moveInstrument(Instrument instrument, bool isAdvanced) const {
    if (isAdvanced && view_.line.isWireKinked) return moveInstrument(Instrument::Wire, false);
    const QString way = isAdvanced ? tr("advance") : tr("withdraw");
    if (hands_.isNeedleInDevice)
      return {isAdvanced ? tr("Choose %1 under the image (%2). Hold the second button of the device that controls the "
                              "needle, and move the device toward the patient; release the button to move back.")
                               .arg(titleOf(instrument), key("train.line.instrument"))
                         : tr("Choose %1 under the image (%2). Hold the second button of the device that controls the "
                              "needle, and move the device away from the patient; release the button to move back.")
                               .arg(titleOf(instrument), key("train.line.instrument")),
              "lineInstrument"};
    return {
        tr("Choose %1 under the image (%2), then press %3, or hold down the button \"%4\" beside it.")
            .arg(titleOf(instrument), key("train.line.instrument"), key("train.line.move", isAdvanced ? 0 : 1), way),
        isAdvanced ? "lineAdvance" : "lineWithdraw"};
  }

  StepAct slide() const {
    if (hands_.isProbeInDevice) return {tr("Slide the probe with the device that controls it."), {}};
    return {tr("Slide the probe with the %1, or drag on the image.").arg(key("train.probe.slide").toLower()), {}};
  }
  StepAct compress() const {
    if (hands_.isProbeInDevice)
      return {tr("Compress the tissue with the device that controls the probe, then release the tissue."),
              "indentation"};
    return {tr("Compress the tissue with %1, then release it with %2, or turn the wheel over the image.")
                .arg(key("train.probe.press", 0), key("train.probe.press", 1)),
            "indentation"};
  }
  StepAct showWire(const QString& words) const {
    if (hands_.isProbeInDevice) return {words.arg(tr("move the device that controls the probe")), {}};
    return {words.arg(tr("rotate the probe with %1, and slide it with the %2")
                          .arg(keys("train.probe.rotate"), key("train.probe.slide").toLower())),
            "rotation"};
  }
  StepAct survey() const {
    if (hands_.isProbeInDevice)
      return {tr("Slide the probe to each vein in turn, and compress each vein until it is flat."), "indentation"};
    return {tr("Slide the probe to each vein in turn (%1), and compress each vein with %2 until it is flat.")
                .arg(key("train.probe.slide").toLower(), key("train.probe.press", 0)),
            "indentation"};
  }
  StepAct showColor() const {
    if (hands_.isColorOn)
      return {
          tr("Keep the vein in the middle of the image and inside the color box for a second. Drag the border of the "
             "box to move it."),
          {}};
    return {tr("Switch color Doppler on: press %1.").arg(key("train.doppler.color")), "color"};
  }
  StepAct release() const {
    if (hands_.isProbeInDevice)
      return {tr("Release the tissue with the device that controls the probe."), "indentation"};
    return {tr("Release the tissue with %1, until the vein is open again.").arg(key("train.probe.press", 1)),
            "indentation"};
  }
  StepAct take() const {
    if (hands_.isNeedleInDevice)
      return {tr("The device that controls the needle is not connected. Connect it, or click Devices and choose "
                 "\"mouse and keyboard\" for the needle."),
              "showDevices"};
    const bool isAlong = hands_.plane == NeedlePlane::InPlane;
    return {tr("Take the needle: press %1, or click the button \"%2\" under the image.")
                .arg(key("train.needle.take"), isAlong ? tr("in-plane") : tr("out-of-plane")),
            isAlong ? "stripAlong" : "stripAcross"};
  }
  StepAct newNeedle() const {
    return {tr("Take a new needle: press %1, or click New needle.").arg(key("train.attempt.newNeedle")),
            "attemptNewNeedle"};
  }
  StepAct advance() const {
    if (hands_.isInstrumentInHand) return chooseNeedle();
    if (hands_.isNeedleInDevice) return {tr("Advance the needle with the device that controls it."), {}};
    // Across the image plane, the tip leaves the image with each advance.
    if (hands_.plane == NeedlePlane::OutOfPlane && !hands_.isProbeInDevice && view_.needle == NeedlePlace::UnderSkin)
      return {
          tr("Advance the needle by a few millimeters (%1, or the button \"advance\" under the image), then slide the "
             "probe with the %2 until the tip is visible again.")
              .arg(key("train.needle.advance", 0), key("train.probe.slide").toLower()),
          "needleAdvance"};
    return {tr("Advance the needle: press %1, or hold down the button \"advance\" under the image.")
                .arg(key("train.needle.advance", 0)),
            "needleAdvance"};
  }
  StepAct chooseNeedle() const {
    return {tr("Choose Needle under the image (%1), so that the device moves the needle again.")
                .arg(key("train.line.instrument")),
            "lineInstrument"};
  }
  StepAct withdraw() const {
    if (hands_.isInstrumentInHand) return chooseNeedle();
    if (hands_.isNeedleInDevice) return {tr("Withdraw the needle with the device that controls it."), {}};
    return {tr("Withdraw the needle: press %1, or hold down the button \"withdraw\" under the image.")
                .arg(key("train.needle.advance", 1)),
            "needleWithdraw"};
  }
  StepAct aimAtVein() const {
    if (hands_.isInstrumentInHand) return chooseNeedle();
    const QString error = view_.aim == NeedleAim::Artery ? tr("The needle points at the artery. %1")
                                                         : tr("The needle misses the vein. %1");
    if (hands_.isNeedleInDevice)
      return {error.arg(tr("Withdraw the needle to the skin with the device that controls it, and aim at the vein.")),
              {}};
    if (!hands_.canTurnNeedle)
      return {error.arg(tr("Withdraw the needle until less than 10 mm of it is under the skin, then aim again: press "
                           "%1, or hold down the button \"withdraw\" under the image.")
                            .arg(key("train.needle.advance", 1))),
              "needleWithdraw"};
    const QString heading = keys("train.needle.heading"), angle = keys("train.needle.angle");
    const QString words =
        view_.needle == NeedlePlace::UnderSkin
            ? tr("Aim at the vein: change the heading (%1) or the angle (%2, or the highlighted buttons).")
                  .arg(heading, angle)
            : tr("Aim at the vein: slide the entry point (%1), or change the heading (%2) or the angle (%3, or the "
                 "highlighted buttons).")
                  .arg(key("train.needle.entry"), heading, angle);
    return {error.arg(words), "needleAngleButtons"};
  }
  StepAct aspirate() const {
    if (hands_.isInstrumentInHand) return chooseNeedle();
    const QString words = hands_.isNeedleInDevice ? tr("Aspirate: hold down the second button of the device that "
                                                       "controls the needle, press %1, or click Aspirate.")
                                                  : tr("Aspirate: press %1, or click Aspirate.");
    return {words.arg(key("train.attempt.aspirate")), "attemptDraw"};
  }
  StepAct freeze() const {
    const QString words = hands_.hasPedal ? tr("Freeze: press the first button of the pedal or %1, or click Freeze.")
                                          : tr("Freeze: press %1, or click Freeze.");
    return {words.arg(key("train.image.freeze")), "freeze"};
  }

  const Procedure& procedure_;
  const AttemptView& view_;
  const HandsNow& hands_;
  const ui::Commands& commands_;
};

}  // namespace

HandsNow handsNow(HapticControl& hands, const LiveModel& live, bool isAspirating) {
  const DeviceChoice& choice = hands.choice();
  // Mouse and keys move a simulated device.
  const bool isSimulated = dynamic_cast<SimulatedDevice*>(hands.deviceOf(choice.device(kNeedleTool)).get()) != nullptr;
  HandsNow now;
  now.isProbeInDevice = hands.drivesProbe() && !hands.probeFollowsMouse();
  now.isNeedleInDevice = !choice.isMouseAssigned(kNeedleTool) && !isSimulated;
  now.hasNeedle = hands.needle().has_value();
  now.hasPedal = !choice.pedal().isEmpty() && hands.deviceOf(choice.pedal());
  now.isAspirating = isAspirating;
  now.isFrozen = live.isFrozen();
  now.isColorOn = live.shown() && live.shown()->setup->color.has_value();
  now.isInstrumentInHand = hands.isInstrumentInHand();
  now.plane = hands.needlePlane();
  if (const NeedlePlacement* held = hands.needleHand()) {
    if (!held->isInBody()) now.angle_deg = held->state().angle_deg;
    now.canTurnNeedle = held->state().advance_mm <= NeedlePlacement::kTurnsUntil_mm;
  }
  return now;
}

StepAct nextAct(const Procedure& procedure, const AttemptView& view, const HandsNow& hands,
                const ui::Commands& commands) {
  return ActFinder(procedure, view, hands, commands).find();
}

}  // namespace insonate::train
