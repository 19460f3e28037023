#include "ResultFeature.h"

#include "../ReviewSession.h"
#include "../page/AttemptPage.h"
#include "../replay/SceneFeature.h"
#include "ReportPaint.h"
#include "ResultPage.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace insonate::review {

ResultFeature::ResultFeature(const ReviewModel& model, AttemptPage& page, SceneFeature& scene)
    : Feature(model),
      page_(page),
      scene_(scene),
      result_(new ResultPage(model.session, model.judging)),
      path_(new PathPane(model.session)) {
  model_.workspace.commands().beginSection(tr("Result"));
  addForAttempt({.id = QStringLiteral("review.result.show"),
                 .text = tr("Result"),
                 .does = tr("shows points, metrics and the needle's path"),
                 .listed = tr("2"),
                 .keys = {{Qt::Key_2}},
                 .perform = [this](ui::KeyPress) { showResult(); }});
  page_.addCenter(QStringLiteral("review.result.show"), "resultTab", tr("Result"), result_);
  page_.addBelow(path_);
  auto* save = ui::pushButton(
      "saveAttempt", model_.save.text(),
      model_.workspace.commands().toolTip(tr("Saves the result as a page, PDF or PNG"), QStringLiteral("review.save")),
      Qt::TabFocus);
  save->setIcon(model_.save.icon());
  connect(save, &QPushButton::clicked, &model_.save, &QAction::trigger);
  page_.addButton(save);
  connect(&page_, &AttemptPage::centerChanged, this, [this] { showPath(); });
  connect(&scene_, &SceneFeature::settingsShown, this, [this] { showPath(); });
}

void ResultFeature::showResult() {
  page_.showCenter(result_);
}

/// The settings of 3D replace the path.
void ResultFeature::showPath() {
  path_->setVisible(page_.showsCenter(result_) && !scene_.showsSettings());
}

void ResultFeature::chooseFile() {
  const QString name = QFileInfo(QString::fromStdString(model_.session.attempt()->file)).completeBaseName();
  const QString file = QFileDialog::getSaveFileName(&model_.workspace, tr("Save the result"),
                                                    QDir::home().filePath(name + QStringLiteral(".pdf")),
                                                    tr("PDF (*.pdf);;Image (*.png)"));
  if (!file.isEmpty()) saveAs(file);
}

void ResultFeature::saveAs(const QString& file) {
  const QImage scene = model_.session.fits() ? scene_.widget().grab().toImage() : QImage();
  const QString error = writeReport(file, *model_.session.attempt(), path_->section(), scene);
  if (!error.isEmpty()) return Q_EMIT model_.workspace.failed(error, {}, {});
  Q_EMIT model_.workspace.written(tr("Result saved as %1.").arg(QFileInfo(file).fileName()),
                                  QFileInfo(file).absolutePath());
}

}  // namespace insonate::review
