#include "KeyTable.h"
#include "ReviewParts.h"

#include <insonate/ui/KeyOffer.h>

#include <QKeyEvent>
#include <QToolButton>
#include <algorithm>
#include <iterator>

namespace insonate::review {

bool ReviewWorkspace::Parts::key(const QKeyEvent& event, bool act) {
  const KeyRow* row = rowFor(event);
  if (!row || !session.attempt()) return false;
  if (!act) return true;
  const auto faster = [this](int by) {
    const auto* at = std::ranges::find(ReviewSession::kSpeeds, session.speed());
    const auto index = std::clamp<std::ptrdiff_t>(at - std::begin(ReviewSession::kSpeeds) + by, 0,
                                                  std::ssize(ReviewSession::kSpeeds) - 1);
    session.setSpeed(ReviewSession::kSpeeds[index]);
  };
  switch (row->command) {
    case Command::Play:
      session.setPlaying(!session.isPlaying());
      break;
    case Command::Step:
      session.setPlaying(false);
      session.step(event.modifiers().testFlag(Qt::ShiftModifier) ? row->wide : row->by);
      break;
    case Command::StepMoment:
      session.stepMoment(int(row->by));
      break;
    case Command::Begin:
      session.setTime(0);
      break;
    case Command::End:
      session.setTime(session.attempt()->end_us);
      break;
    case Command::Slower:
      faster(-1);
      break;
    case Command::Faster:
      faster(1);
      break;
    case Command::ShowReplay:
    case Command::ShowResult:
      showTab(row->command == Command::ShowReplay ? kReplayTab : kResultTab);
      break;
    case Command::ShowLook:
      look_->toggle();
      break;
    case Command::ShowJudging:
      judge_->toggle();
      break;
    case Command::List:
      session.close();
      break;
  }
  return true;
}

bool ReviewWorkspace::Parts::keyEvent(QEvent* event) {
  return ui::offerKey(*event, [this](const QKeyEvent& pressed, bool act) { return key(pressed, act); });
}

}  // namespace insonate::review
