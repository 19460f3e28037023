#include "Feature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"

#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QStringList>
#include <utility>

namespace insonate::train {
namespace {

/// Headings in the order of KeySection.
QStringList headings() {
  return {Feature::tr("Probe"),    Feature::tr("Needle"),       Feature::tr("Image"),
          Feature::tr("Attempts"), Feature::tr("Measurements"), Feature::tr("Patient in 3D and CT"),
          Feature::tr("Tissue"),   Feature::tr("Undo")};
}

}  // namespace

Feature::Feature(TrainModel& model, TrainLayout& layout)
    : QObject(&layout.workspace()), model_(model), layout_(layout) {}

ui::Commands& Feature::commands() const {
  return layout_.workspace().commands();
}

void Feature::beginSection(KeySection section) {
  // All of them, so that their order does not depend on the order of the features.
  const QStringList all = headings();
  for (const QString& heading : all) commands().beginSection(heading);
  commands().beginSection(all.at(int(section)));
}

void Feature::addCommand(ui::Command command) {
  if (!command.isAvailable) command.isAvailable = [this] { return isPatientShown(); };
  commands().add(std::move(command));
}

QAction* Feature::addSwitch(const QString& id, std::function<bool()> isOn) {
  QAction* action = commands().action(id);
  action->setCheckable(true);
  // Qt changes the mark before the command is performed, which may be unavailable or refused.
  connect(action, &QAction::triggered, this, [action, isOn = std::move(isOn)] { action->setChecked(isOn()); });
  layout_.addToViewMenu(*action);
  return action;
}

bool Feature::isPatientShown() const {
  return model_.patientCase.patient() && !layout_.isPageShown();
}

std::vector<ui::CommandKey> Feature::keys(std::initializer_list<int> pressed, Qt::KeyboardModifiers modifiers) {
  std::vector<ui::CommandKey> all;
  for (const int key : pressed) all.push_back({key, modifiers, {}});
  return all;
}

Feature::Perform Feature::once(std::function<void()> perform) {
  return [perform = std::move(perform)](ui::KeyPress press) {
    if (!press.repeated) perform();
  };
}

}  // namespace insonate::train
