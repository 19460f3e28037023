#include "OpeningWords.h"

#include "../class/ClassWords.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <QStringList>
#include <algorithm>

namespace insonate::review {
namespace {

/// "'Jugular test' until 20 Nov 2026 14:30, with a code (3 of 12 can take it)"
QString openingWords(const ClassFacts& facts, const TestOpening& opening, OpeningState state) {
  QString words =
      QStringLiteral("'%1'").arg(levelTitle(facts.curriculum ? &*facts.curriculum : nullptr, opening.level));
  if (state == OpeningState::Waiting) words += tr(" from %1").arg(ui::dayAndTimeOf(opening.start_us));
  words += opening.end_us ? tr(" until %1").arg(ui::dayAndTimeOf(*opening.end_us)) : tr(" until you close the test");
  if (opening.hasCode) words += tr(", with a code");
  const auto ready = facts.ready.find(opening.level);
  return ready == facts.ready.end() ? words : words + tr(" (%1)").arg(readinessWords(facts, ready->second));
}

QString listedWords(const ClassFacts& facts, OpeningState state, std::int64_t now_us) {
  QStringList words;
  for (const TestOpening& one : facts.openings)
    if (one.curriculum == facts.curriculum->name && stateAt(one, now_us) == state)
      words << openingWords(facts, one, state);
  return words.join(QStringLiteral("; "));
}

}  // namespace

QString readinessWords(const ClassFacts& facts, int ready) {
  return tr("%1 of %2 can take it").arg(ready).arg(facts.learners.size());
}

QString signedWordOf(OpeningState state) {
  switch (state) {
    case OpeningState::Waiting:
      return tr("◔ waiting");
    case OpeningState::Open:
      return tr("● open");
    case OpeningState::Ended:
      return tr("○ ended");
    case OpeningState::Closed:
      break;
  }
  return tr("○ closed");
}

QString openTestsWords(const ClassFacts& facts, std::int64_t now_us) {
  if (!facts.curriculum || !std::ranges::count(facts.curriculum->levels, Assistance::Test, &Level::assistance))
    return {};
  const QString open = listedWords(facts, OpeningState::Open, now_us);
  const QString waiting = listedWords(facts, OpeningState::Waiting, now_us);
  QStringList words;
  words << (open.isEmpty() ? tr("○ No test is open: an attempt at a test is practice until you open the test")
                           : tr("● Tests that are open now: %1").arg(open));
  if (!waiting.isEmpty()) words << tr("◔ Tests that open later: %1").arg(waiting);
  return words.join(QStringLiteral("   ·   "));
}

}  // namespace insonate::review
