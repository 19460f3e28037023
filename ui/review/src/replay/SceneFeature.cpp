#include "SceneFeature.h"

#include "../ReviewSession.h"
#include "../page/AttemptPage.h"
#include "ReplayScene.h"

#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>

#include <QScrollArea>
#include <QSettings>
#include <QToolButton>

namespace insonate::review {

SceneFeature::SceneFeature(const ReviewModel& model, AttemptPage& page)
    : Feature(model), scene_(new ReplayScene(model.session, this)) {
  ui::Commands& commands = model_.workspace.commands();
  commands.beginSection(tr("3D"));
  addForAttempt(
      {.id = QStringLiteral("review.scene.settings"),
       .text = tr("3D"),
       .does = tr("shows or hides the panel for the contents of the 3D view (structures, skin, clipping plane)"),
       .listed = tr("3"),
       .keys = {{Qt::Key_3}},
       .perform = [this](ui::KeyPress) { tab_->toggle(); }});
  commands.addListed(tr("Left drag, wheel"), tr("rotates or zooms the 3D view"));
  commands.addListed(tr("R"), tr("shows the patient from the front"));
  tab_ = page.addToggle(QStringLiteral("review.scene.settings"), "sceneTab", tr("3D"));
  page.addBelow(&scene_->widget());
  page.addBelow(&scene_->panelArea());
  passKeysOf(*scene_->widget().focusProxy());
  scene_->panelArea().hide();
  connect(tab_, &QToolButton::toggled, &scene_->panelArea(), &QWidget::setVisible);
  connect(tab_, &QToolButton::toggled, this, &SceneFeature::settingsShown);
  scene_->setRested([this] { Q_EMIT readinessChanged(); });
}

ui::ViewWidget& SceneFeature::widget() {
  return scene_->widget();
}

bool SceneFeature::showsSettings() const {
  return tab_->isChecked();
}

bool SceneFeature::isReady() const {
  return !model_.session.attempt() || scene_->isAtRest();
}

void SceneFeature::save(QSettings& settings) const {
  settings.beginGroup(QStringLiteral("scene"));
  scene_->panel().save(settings);
  settings.endGroup();
}

void SceneFeature::restore(QSettings& settings) {
  settings.beginGroup(QStringLiteral("scene"));
  scene_->panel().restore(settings);
  settings.endGroup();
}

}  // namespace insonate::review
