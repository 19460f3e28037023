#include "History.h"

#include "StatusLine.h"

#include <QString>
#include <utility>

namespace insonate::train {

namespace {

void sayOutcome(History::Outcome outcome, const History& history, StatusLine& status, const QString& done,
                const QString& nothing) {
  if (outcome == History::Outcome::Done) status.say(done.arg(QString::fromStdString(history.lastWords())));
  if (outcome == History::Outcome::Nothing) status.say(nothing);
}

}  // namespace

void History::add(std::string what, Exchange exchange, std::string key) {
  const auto now = std::chrono::steady_clock::now();
  const bool joins = open_ && !key.empty() && !past_.empty() && past_.back().key == key && now - lastAdded_ < kOneStep;
  lastAdded_ = now;
  future_.clear();
  if (joins) return;  // The state before the first of them is stored already.
  if (past_.size() == kMost) past_.erase(past_.begin());
  past_.push_back({std::move(what), std::move(key), std::move(exchange)});
  open_ = true;
}

void History::clear() {
  past_.clear();
  future_.clear();
  open_ = false;
}

History::Outcome History::go(std::vector<Step>& from, std::vector<Step>& to) {
  if (from.empty()) return Outcome::Nothing;
  open_ = false;
  if (!from.back().exchange()) return Outcome::Refused;
  lastWords_ = from.back().what;
  to.push_back(std::move(from.back()));
  from.pop_back();
  return Outcome::Done;
}

void undoStep(History& history, StatusLine& status) {
  sayOutcome(history.undo(), history, status, StatusLine::tr("Undone: %1."),
             StatusLine::tr("There is nothing to undo."));
}

void redoStep(History& history, StatusLine& status) {
  sayOutcome(history.redo(), history, status, StatusLine::tr("Redone: %1."),
             StatusLine::tr("There is nothing to redo."));
}

}  // namespace insonate::train
