#include "AccountWindow.h"
#include "account/AccountMenu.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/web/WebServer.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QDir>
#include <QStringList>
#include <QSysInfo>
#include <chrono>
#include <filesystem>
#include <stdexcept>

namespace {

using namespace insonate;
using test::waitUntil;

constexpr const char *kTitle = "Broad neck", *kPassword = "12345678";

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

void succeed(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

/// A site whose class practices on a case that only the server has.
class SiteCases : public test::AccountWindow {
 protected:
  void SetUp() override {
    QDir(ui::downloadFolder()).removeRecursively();
    AccountWindow::SetUp();
    publish(test::smallCase());
    const auto store = valueOf(CurriculumStore::open(home.filePath("served.sqlite").toStdString(),
                                                     {.workstation = "server", .passwordCost = PasswordCost::Minimum}));
    const auto root = valueOf(store.createFirstAdministrator({"root", "Root R.", "", Role::Administrator}, kPassword));
    const Person anna = valueOf(PeopleStore(root).add({"anna", "Anna A.", "", Role::Trainee}, kPassword));
    Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    curriculum.levels.front().caseName = kTitle;
    valueOf(PublishedCurricula(root).publish(curriculum.name, curriculum.version, curriculumText(curriculum)));
    const Cohort spring = valueOf(CohortStore(root).add("Spring"));
    succeed(CohortStore(root).join(spring.id, anna.id, false));
    succeed(CohortStore(root).setCurriculum(spring.id, curriculum.name, curriculum.version));
    const std::string token = valueOf(Workstations(root).add(QSysInfo::machineHostName().toStdString()));
    server.emplace(valueOf(web::WebServer::start(store, {.port = 0, .cases = cases()})));
    // The window may replace a message before a busy computer reads it.
    auto* menu = window->findChild<ui::AccountMenu*>();
    QObject::connect(menu, &ui::AccountMenu::statusMessage, menu, [this](const QString& one) { messages << one; });
    succeed(site().setServer(QString::fromStdString(server->url()), QString::fromStdString(token)));
    signIn("anna", kPassword);
    QDialog* choosing = dialogWith("passwordNew");
    type(choosing, "passwordOld", kPassword);
    type(choosing, "passwordNew", "of my own choice");
    type(choosing, "passwordAgain", "of my own choice");
    go(choosing);
    ASSERT_TRUE(waitUntil([&] { return account().isSignedIn() && !account().mustChangePassword(); }));
  }

  void TearDown() override {
    window.reset();
    EXPECT_TRUE(ui::waitForJobs(std::chrono::seconds(30)));
  }

  std::filesystem::path cases() const { return home.filePath("cases").toStdString(); }
  void publish(PatientCase patient) const {
    patient.manifest.title = kTitle;
    std::filesystem::create_directories(cases());
    valueOf(saveCaseVersion(patient, cases() / "broad", "2026-11-22", ""));
    valueOf(publishCase(patient, cases() / "broad", "2026-11-22"));
  }
  ui::SiteExchange& site() { return *window->findChild<ui::SiteExchange*>(); }
  /// Waits until a published version other than `former` is here. The window may have downloaded it already.
  QString downloaded(const QString& former = {}) {
    site().exchangeNow();
    std::optional<QString> place;
    EXPECT_TRUE(waitUntil([&] {
      place = ui::findCaseLocation(kTitle);
      return place && ui::isDownloaded(*place) && *place != former;
    })) << site().outcome().toStdString();
    return place.value_or(QString());
  }

  std::optional<web::WebServer> server;
  QStringList messages;  ///< all messages of the exchange with the server
};

TEST_F(SiteCases, AreDownloadedForTheClassesOfThisComputer) {
  const QString place = downloaded();
  EXPECT_TRUE(waitUntil([&] { return messages.join(' ').contains("case 'Broad neck'"); }))
      << messages.join('\n').toStdString();
  PatientCase next = test::smallCase();
  next.labels.voxels[0] ^= 1;
  const std::string former = voxelHashOf(valueOf(readCase(place.toStdString())).patient);
  publish(next);
  EXPECT_FALSE(downloaded(place).isEmpty());
  EXPECT_EQ(ui::placeOfVersion(kTitle, former), place) << "for replays";
}

TEST_F(SiteCases, ReplaceCasesOfTheSameTitleOnThisComputer) {
  ui::rememberCase({home.path(), kTitle});
  EXPECT_NE(downloaded(), home.path());
  EXPECT_FALSE(ui::isDownloaded(home.path()));
}

TEST_F(SiteCases, AreOpenedWithoutAFolderToSaveTo) {
  const QString place = downloaded();
  struct Origin : ui::Workspace {
    void setCase(std::shared_ptr<const PatientCase> opened) override { patient = std::move(opened); }
    void setOrigin(const ui::CaseOrigin& of) override { origin = of; }
    std::shared_ptr<const PatientCase> patient;
    ui::CaseOrigin origin;
  };
  auto* workspace = new Origin;
  window->addWorkspace("origin", "Origin", "train", workspace);
  window->open(place);
  ASSERT_TRUE(waitUntil([&] { return workspace->patient != nullptr; }));
  EXPECT_TRUE(workspace->origin.folder.isEmpty());
  EXPECT_EQ(workspace->origin.readFrom, place);
  EXPECT_TRUE(workspace->origin.isDownloaded());
  EXPECT_TRUE(ui::recentCases().empty()) << "a new version comes into another folder";
}

}  // namespace
