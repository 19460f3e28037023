#include "StructureAppearance.h"

#include "../labels/LabelSession.h"
#include "OpenCase.h"
#include "StructureList.h"
#include "TermsEditor.h"

#include <insonate/tissue/Labels.h>

#include <QSettings>
#include <QUndoCommand>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace insonate::prepare {
namespace {

/// Steps of a drag follow each other faster than this, separate changes slower.
constexpr std::chrono::milliseconds kOneDrag{700};

/// A change of the appearance of one structure. Changes of opacity in quick succession are merged.
class LookEdit : public QUndoCommand {
 public:
  using Apply = std::function<void(std::uint8_t label, const StructureLook& look)>;

  LookEdit(std::uint8_t label, const StructureLook& before, const StructureLook& after, Apply apply,
           const QString& what, QUndoCommand* parent)
      : QUndoCommand(what, parent), label_(label), before_(before), after_(after), apply_(std::move(apply)) {}
  void undo() override { apply_(label_, before_); }
  void redo() override { apply_(label_, after_); }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const LookEdit&>(*other);
    StructureLook onlyOpacity = before_;
    onlyOpacity.opacity = next.after_.opacity, onlyOpacity.onSlices = next.after_.onSlices;
    if (next.label_ != label_ || onlyOpacity != next.after_ || next.when_ - when_ > kOneDrag) return false;
    after_ = next.after_, when_ = next.when_;
    setObsolete(before_ == after_);
    return true;
  }

 private:
  std::uint8_t label_;
  StructureLook before_, after_;
  Apply apply_;
  std::chrono::steady_clock::time_point when_ = std::chrono::steady_clock::now();
};

}  // namespace

StructureAppearance::StructureAppearance(OpenCase& openCase, const StructureList& structures, const TermsEditor& terms,
                                         LabelSession& labeling, QObject* parent)
    : QObject(parent),
      openCase_(openCase),
      structures_(structures),
      terms_(terms),
      labeling_(labeling),
      looks_(defaultLooks({})) {
  connect(&openCase_, &OpenCase::opened, this, [this] { takeOver(); });
  connect(&openCase_, &OpenCase::saved, this, [this] { takeShown(openCase_.patient()->manifest.shown, saved_); });
}

void StructureAppearance::takeOver() {
  const auto& patient = openCase_.patient();
  looks_ = defaultLooks(patient ? patient->colors : LabelColors{});
  for (const auto& [label, habit] : habits_)
    // Without skin, another patient would look incomplete.
    looks_[label].opacity = habit.opacity, looks_[label].visible = habit.visible || label == kSkin,
    looks_[label].onSlices = habit.onSlices;
  if (patient) takeShown(patient->manifest.shown, looks_);
  saved_ = looks_;
}

void StructureAppearance::protectHidden() {
  LabelRules rules = labeling_.rules();
  for (int label = 0; label < 256; ++label) rules.hidden.set(std::size_t(label), !looks_[std::size_t(label)].visible);
  if (rules.hidden != labeling_.rules().hidden) labeling_.setRules(rules);
}

QUndoCommand* StructureAppearance::edit(std::uint8_t label, const StructureLook& look, const QString& what,
                                        QUndoCommand* parent) {
  return new LookEdit(
      label, looks_[label], look, [this](std::uint8_t one, const StructureLook& value) { apply(one, value); }, what,
      parent);
}

void StructureAppearance::push(std::uint8_t label, const StructureLook& look, const QString& what) {
  if (!openCase_.patient() || look == looks_[label]) return;
  openCase_.undoStack().push(edit(label, look, what, nullptr));
}

void StructureAppearance::apply(std::uint8_t label, const StructureLook& look) {
  looks_[label] = look;
  habits_[label] = {look.opacity, look.visible, look.onSlices};
  protectHidden();
  Q_EMIT lookChanged(label);
}

void StructureAppearance::setColor(std::uint8_t label, views::Color color) {
  StructureLook look = looks_[label];
  look.color = color;
  push(label, look, tr("color of %1").arg(terms_.nameOf(label)));
}

void StructureAppearance::setOpacity(std::uint8_t label, double opacity) {
  StructureLook look = looks_[label];
  look.opacity = std::clamp(opacity, 0.0, 1.0);
  push(label, look, tr("opacity of %1").arg(terms_.nameOf(label)));
}

void StructureAppearance::setShareOnSlices(std::uint8_t label, double share) {
  StructureLook look = looks_[label];
  look.onSlices = std::clamp(share, 0.0, 1.0);
  push(label, look, tr("opacity of %1").arg(terms_.nameOf(label)));
}

void StructureAppearance::setVisible(std::uint8_t label, bool visible) {
  StructureLook look = looks_[label];
  look.visible = visible;
  push(label, look, (visible ? tr("show %1") : tr("hide %1")).arg(terms_.nameOf(label)));
}

void StructureAppearance::showOnly(std::uint8_t label) {
  auto all = std::make_unique<QUndoCommand>(tr("show only %1").arg(terms_.nameOf(label)));
  for (const std::uint8_t one : structures_.labels()) {
    StructureLook look = looks_[one];
    look.visible = one == label;
    if (look != looks_[one]) edit(one, look, {}, all.get());
  }
  if (all->childCount() > 0) openCase_.undoStack().push(all.release());
}

void StructureAppearance::showAll() {
  auto all = std::make_unique<QUndoCommand>(tr("show all"));
  for (const std::uint8_t one : structures_.labels()) {
    StructureLook look = looks_[one];
    look.visible = true;
    if (look != looks_[one]) edit(one, look, {}, all.get());
  }
  if (all->childCount() > 0) openCase_.undoStack().push(all.release());
}

void StructureAppearance::restore(const StructureLooks& looks, QUndoCommand& all) {
  for (std::size_t label = 1; label < looks.size(); ++label)
    if (looks[label] != looks_[label]) edit(std::uint8_t(label), looks[label], {}, &all);
}

void StructureAppearance::saveHabits(QSettings& settings) const {
  settings.beginWriteArray(QStringLiteral("structures"));
  int index = 0;
  for (const auto& [label, habit] : habits_) {
    settings.setArrayIndex(index++);
    settings.setValue(QStringLiteral("label"), int(label));
    settings.setValue(QStringLiteral("opacity"), habit.opacity);
    settings.setValue(QStringLiteral("visible"), habit.visible);
    settings.setValue(QStringLiteral("onSlices"), habit.onSlices);
  }
  settings.endArray();
}

void StructureAppearance::restoreHabits(QSettings& settings) {
  const auto share = [&settings](const char* key, double otherwise) {
    const double value = settings.value(QLatin1String(key), otherwise).toDouble();
    return std::clamp(std::isfinite(value) ? value : otherwise, 0.0, 1.0);
  };
  habits_.clear();
  const int count = settings.beginReadArray(QStringLiteral("structures"));
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    const int label = settings.value(QStringLiteral("label")).toInt();
    if (label < 1 || label > 255) continue;
    habits_[std::uint8_t(label)] = {share("opacity", 1), settings.value(QStringLiteral("visible"), true).toBool(),
                                    share("onSlices", defaultShareOnSlices(std::uint8_t(label)))};
  }
  settings.endArray();
}

}  // namespace insonate::prepare
