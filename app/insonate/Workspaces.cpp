#include "Workspaces.h"

#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/review/ReviewWorkspace.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <QAction>

namespace insonate::app {

void addWorkspaces(ui::MainWindow& window) {
  const auto action = [&window](const char* id) { return window.commands().action(QLatin1String(id)); };
  auto* prepare = new prepare::PrepareWorkspace(window.tasks());
  prepare->addOpenAction(action("window.case.open"));
  prepare->addOpenAction(action("window.case.import"));
  prepare->addOpenAction(action("window.case.library"));
  prepare->addOpenAction(action("window.case.textbook"));
  prepare->setCaseActions(action("window.case.open"), action("window.case.import"), action("window.case.reload"));
  window.addWorkspace(QStringLiteral("prepare"), QObject::tr("Prepare"), QStringLiteral("prepare"), prepare);

  window.addWorkspace(QStringLiteral("train"), QObject::tr("Train"), QStringLiteral("train"),
                      new train::TrainWorkspace);

  auto* review = new review::ReviewWorkspace(window.tasks());
  review->addOpenAction(action("window.attempt.open"));
  window.addWorkspace(QStringLiteral("review"), QObject::tr("Review"), QStringLiteral("review"), review);
}

}  // namespace insonate::app
