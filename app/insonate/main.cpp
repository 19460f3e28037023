#include "Arguments.h"
#include "Benchmark.h"
#include "FirstImage.h"
#include "Screenshot.h"
#include "Workspaces.h"

#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/review/ReviewWorkspace.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/FieldEventFilter.h>
#include <insonate/ui/FileDialogTraces.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/StoreAddress.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>

#include <malloc.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>

namespace {

using namespace insonate;

/// Qt ends the program where there is no display, with words for programmers.
void tell(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) {
    std::fputs(
        "insonate: There is no display to open a window on. Start it on a desktop, or use insonate-cli without one.\n",
        stderr);
    std::_Exit(1);
  }
  if (type == QtCriticalMsg) std::fprintf(stderr, "insonate: %s\n", qPrintable(message));
}

/// Volumes, scenes and surfaces come and go by tens of megabytes. Left to itself, glibc takes more and more of them
/// into its heaps, whose holes stay the program's: some gigabytes after a minute. Whatever is large is the system's
/// again at once. See mallopt(3), M_MMAP_THRESHOLD.
void giveMemoryBack() {
  constexpr int kLarge_bytes = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, kLarge_bytes);
}

using Leave = std::function<void(const QString& error)>;

/// Signs the person in, if one is given, and opens the case.
void beginWith(ui::MainWindow& window, const app::Arguments& arguments, const Leave& leave) {
  // From within the event loop, which a failure may end.
  const auto begin = [&window, folder = QString::fromStdString(arguments.caseFolder)] {
    folder.isEmpty() ? window.openTextbook() : window.open(folder);
  };
  if (arguments.person.empty())
    QTimer::singleShot(0, &window, begin);
  else
    window.account().signIn(
        QString::fromStdString(arguments.person), qEnvironmentVariable("INSONATE_PASSWORD"),
        [begin, leave](const Result<void>& in) { in ? begin() : leave(QString::fromStdString(in.error().message)); });
}

void beginWithPerson(ui::MainWindow& window, const app::Arguments& arguments) {
  window.findChild<prepare::PrepareWorkspace*>()->keepUnsavedWorkIn(
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/unsaved"));
  if (arguments.person.empty()) window.askAtFirstStart();
}

QString databaseOf(const app::Arguments& arguments) {
  return arguments.database.empty() ? ui::defaultStoreAddress() : QString::fromStdString(arguments.database);
}

int run(QApplication& application, const app::Arguments& arguments) {
  // Screenshots and measurements neither depend on the user's layout nor change it.
  std::unique_ptr<QTemporaryDir> ownSettings;
  const bool measures = !arguments.benchmark.empty() || arguments.untilImage;
  if (!arguments.screenshot.empty() || measures) {
    ownSettings = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, ownSettings->path());
  }
  int status = 0;
  ui::MainWindow window(std::make_unique<ui::Account>(databaseOf(arguments)));
  app::addWorkspaces(window);
  window.showWorkspace(QStringLiteral("train"));
  window.restoreLayout();
  if (!arguments.workspace.empty()) window.showWorkspace(QString::fromStdString(arguments.workspace));

  const Leave leave = [&status, &window](const QString& error) {
    if (!error.isEmpty()) {
      std::fprintf(stderr, "insonate: %s\n", qPrintable(error));
      status = 1;
    }
    window.closeAtOnce();
  };
  // A person reads the error in the window and can open another case; a script reads it here.
  const bool forScript = !arguments.screenshot.empty() || measures;
  const auto first =
      QObject::connect(&window, &ui::MainWindow::caseFailed, &window, [leave, forScript](const QString& what) {
        forScript ? leave(what) : void(std::fprintf(stderr, "insonate: %s\n", qPrintable(what)));
      });
  QObject::connect(&window, &ui::MainWindow::readyChanged, &window, [&window, first] {
    if (window.current().patient) QObject::disconnect(first);
  });
  // An attempt that cannot be opened, or whose case is not there.
  if (forScript)
    QObject::connect(window.findChild<review::ReviewWorkspace*>(), &ui::Workspace::failed, &window,
                     [leave](const QString& what) { leave(what); });
  std::unique_ptr<app::Screenshot> screenshot;
  if (!arguments.screenshot.empty()) {
    window.resize(QSize(arguments.width_px, arguments.height_px) / window.devicePixelRatioF());
    screenshot =
        std::make_unique<app::Screenshot>(window, QString::fromStdString(arguments.screenshot.string()), leave);
  }
  std::unique_ptr<app::FirstImage> firstImage;
  if (arguments.untilImage)
    firstImage = std::make_unique<app::FirstImage>(window, [leave] {
      std::printf("%.0f\n", app::sinceStart_ms());
      ui::waitForBuiltInCache();
      leave({});
    });
  window.show();
  std::unique_ptr<app::Benchmark> benchmark;
  if (!arguments.benchmark.empty())
    benchmark = std::make_unique<app::Benchmark>(
        window, *window.findChild<train::TrainWorkspace*>(), *window.findChild<prepare::PrepareWorkspace*>(),
        app::BenchmarkPlan{arguments.benchmark, arguments.caseFolder, arguments.quick}, leave);
  beginWith(window, arguments, leave);
  QObject::connect(&window, &ui::MainWindow::handsChosen, window.findChild<train::TrainWorkspace*>(),
                   &train::TrainWorkspace::setHands);
  if (!forScript) beginWithPerson(window, arguments);
  application.exec();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = app::parseArguments(argc, argv);
  if (const int* status = std::get_if<int>(&arguments)) return *status;
  if (const QString refused = ui::refusalOfStore(databaseOf(std::get<app::Arguments>(arguments))); !refused.isEmpty()) {
    std::fprintf(stderr, "insonate: %s\n", qPrintable(refused));
    return 2;
  }
  giveMemoryBack();
  qInstallMessageHandler(tell);
  ui::prepareGraphics();
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("Insonate"));
  QCoreApplication::setApplicationName(QStringLiteral("insonate"));
  QCoreApplication::setApplicationVersion(QStringLiteral(INSONATE_VERSION));
  ui::applyTheme(application);
  ui::removeFileDialogTraces(application);
  ui::filterFieldEvents(application);
  const int status = run(application, std::get<app::Arguments>(arguments));
  // Files are written beside their target and moved, so that a job that is cut off leaves nothing half done.
  if (!ui::waitForJobs(std::chrono::seconds(5))) std::_Exit(status);
  return status;
}
