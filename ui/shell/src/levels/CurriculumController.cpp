#include "CurriculumController.h"

#include "JobThreads.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/teaching/TeachingHere.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>

#include <QCoreApplication>
#include <QPointer>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

using Kind = OfferedCurriculum::Kind;

constexpr int kSoon_ms = 1500, kAgain_ms = 15'000;
constexpr int kMaxSteps = 200;

/// Built-in necks, the cases opened on this computer, those downloaded from the site's server, and those of the
/// library.
TeachingNames namesHere(const std::vector<RecentCase>& library) {
  TeachingNames names = teachingNames().value_or(TeachingNames());
  const auto add = [&names](const std::string& title) {
    if (std::ranges::find(names.cases, title) == names.cases.end()) names.cases.push_back(title);
  };
  for (const RecentCase& one : recentCases()) add(one.title.toStdString());
  for (const auto& place : downloadedCases(downloadFolder().toStdString()))
    if (const auto manifest = readCaseManifest(place)) add(manifest->title);
  for (const RecentCase& one : library) add(one.title.toStdString());
  return names;
}

}  // namespace

CurriculumController::CurriculumController(Account& account, QObject* parent)
    : QObject(parent), account_(&account), known_(namesHere({})) {
  history_.setUndoLimit(kMaxSteps);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &CurriculumController::save);
  connect(QCoreApplication::instance(), &QCoreApplication::aboutToQuit, this, &CurriculumController::save);
  connect(account_, &Account::reconnected, this, [this] {
    Q_EMIT statusMessage({}, false);
    save();
    refresh();
  });
  readLibrary();
  connect(account_, &Account::casesDownloaded, this, &CurriculumController::refreshCases);
  refresh();
}

CurriculumController::~CurriculumController() {
  if (account_) save();
}

/// On another thread, since the library may be on a slow network.
void CurriculumController::readLibrary() {
  runInBackground([self = QPointer(this)] {
    auto library = libraryCases();
    QMetaObject::invokeMethod(qApp, [self, library = std::move(library)] {
      if (!self) return;
      self->library_ = library;
      self->showCases();
    });
  });
}

void CurriculumController::refreshCases() {
  showCases();
  readLibrary();
}

void CurriculumController::showCases() {
  std::vector<std::string> cases = namesHere(library_).cases;
  if (cases == known_.cases) return;
  known_.cases = std::move(cases);
  if (curriculum_) show(std::move(*curriculum_));
}

void CurriculumController::refresh() {
  account_->query<Shelf>(
      this,
      [](const SignedIn& by) -> Result<Shelf> {
        auto offers = allCurricula(by);
        if (!offers) return tl::unexpected(offers.error());
        auto cohorts = CohortStore(by).cohorts();
        if (!cohorts) return tl::unexpected(cohorts.error());
        return Shelf{std::move(*offers), std::move(*cohorts)};
      },
      [this](Result<Shelf> shelf) {
        if (!shelf) return Q_EMIT statusMessage(QString::fromStdString(shelf.error().message), true);
        offers_ = std::move(shelf->offers), cohorts_ = std::move(shelf->cohorts);
        Q_EMIT offersChanged();
        if (!chosen_ && !offers_.empty()) choose(offers_.front());
      });
}

void CurriculumController::choose(const OfferedCurriculum& offer) {
  if (chosen_ == offer) return;
  afterSaving([this, offer] { read(offer); }, [this] { Q_EMIT curriculumChanged(); });
}

void CurriculumController::afterSaving(std::function<void()> go, std::function<void()> refused) {
  if (saved_ || contested_ || !isDraft()) return go();
  go_ = std::move(go), refused_ = std::move(refused);
  save();
}

void CurriculumController::read(const OfferedCurriculum& offer) {
  account_->query<std::string>(
      this, [offer](const SignedIn& by) { return textOf(by, offer); },
      [this, offer, round = ++round_](const Result<std::string>& text) {
        if (round == round_) take(offer, text);
      });
}

void CurriculumController::take(const OfferedCurriculum& offer, const Result<std::string>& text) {
  auto curriculum = text ? parseDraft(*text) : tl::unexpected(text.error());
  if (!curriculum) {
    Q_EMIT curriculumChanged();  // the selected curriculum stays selected
    return Q_EMIT statusMessage(QString::fromStdString(curriculum.error().message), true);
  }
  chosen_ = offer, kept_ = sent_ = *text;
  saved_ = true, contested_ = false;
  history_.clear(), field_.clear();
  soon_.stop();
  show(std::move(*curriculum));
  Q_EMIT savingChanged();
}

void CurriculumController::takeDraft(const Result<KeptDraft>& draft) {
  if (!draft) return Q_EMIT statusMessage(QString::fromStdString(draft.error().message), true);
  ++round_;
  take({draft->name, 0, Kind::Draft}, draft->text);
  refresh();
}

void CurriculumController::show(Curriculum curriculum) {
  curriculum_ = std::move(curriculum);
  errors_ = isDraft() ? findDraftErrors(*curriculum_, known_) : std::vector<DraftError>();
  Q_EMIT curriculumChanged();
}

void CurriculumController::changed() {
  saved_ = false;
  if (!contested_) soon_.start(kSoon_ms);
  Q_EMIT savingChanged();
}

/// Changes only the curriculum itself; the controller announces the change once the stack has taken it.
class CurriculumController::Edit final : public QUndoCommand {
 public:
  Edit(std::optional<Curriculum>& curriculum, Curriculum after, int step)
      : curriculum_(curriculum), before_(*curriculum), after_(std::move(after)), step_(step) {}

  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const Edit*>(other);
    if (next->step_ != step_) return false;
    after_ = next->after_;
    return true;
  }
  void undo() override { curriculum_ = before_; }
  void redo() override { curriculum_ = after_; }

 private:
  std::optional<Curriculum>& curriculum_;
  Curriculum before_, after_;
  int step_;
};

void CurriculumController::edit(const QString& field, const std::function<void(Curriculum&)>& change) {
  if (!isDraft()) return;
  Curriculum edited = *curriculum_;
  change(edited);
  if (edited == *curriculum_) return;
  if (field.isEmpty() || field != field_) ++step_;
  field_ = field;
  history_.push(new Edit(curriculum_, std::move(edited), step_));
  show(*curriculum_);
  changed();
}

void CurriculumController::undo() {
  if (!canUndo()) return;
  history_.undo();
  field_.clear();
  show(*curriculum_);
  changed();
}

void CurriculumController::redo() {
  if (!canRedo()) return;
  history_.redo();
  field_.clear();
  show(*curriculum_);
  changed();
}

/// The account answers in order, so that the next draft may be sent before the last answer; if one is refused, the next
/// is refused, too.
void CurriculumController::save() {
  if (saved_ || contested_ || !isDraft()) return;
  soon_.stop();
  const std::string text = curriculumText(*curriculum_);
  account_->query<void>(
      this,
      [name = curriculum_->name, text, before = std::exchange(sent_, text)](const SignedIn& by) {
        return PublishedCurricula(by).saveDraft(name, text, before);
      },
      [this, text, name = curriculum_->name, round = round_](const Result<void>& done) {
        if (round == round_) return takeSaved(text, done);
        if (!done)
          Q_EMIT statusMessage(
              tr("The last changes of the draft %1 were not saved. ").arg(QString::fromStdString(name)) +
                  QString::fromStdString(done.error().message),
              true);
      });
}

void CurriculumController::takeSaved(const std::string& text, const Result<void>& done) {
  if (!done) return handleRefusal(done.error().message);
  kept_ = text;
  saved_ = isDraft() && text == curriculumText(*curriculum_);
  Q_EMIT savingChanged();
  if (!go_) return;
  if (!saved_) return save();
  std::exchange(go_, {})();
}

/// The draft was refused: another user has saved, or the store cannot save now and the draft is sent again later.
void CurriculumController::handleRefusal(const std::string& refusal) {
  account_->query<std::string>(
      this, [name = curriculum_->name](const SignedIn& by) { return PublishedCurricula(by).draft(name); },
      [this, refusal, round = round_](const Result<std::string>& theirs) {
        if (round != round_) return;
        contested_ = theirs && *theirs != kept_;
        sent_ = kept_;
        if (!contested_) soon_.start(kAgain_ms);
        Q_EMIT savingChanged();
        if (std::exchange(go_, {})) refused_();
        Q_EMIT statusMessage(QString::fromStdString(refusal), true);
      });
}

void CurriculumController::reloadDraft() {
  const OfferedCurriculum offer = *chosen_;
  saved_ = true;
  chosen_.reset();
  choose(offer);
}

void CurriculumController::overwriteTheirs() {
  account_->query<std::string>(
      this, [name = curriculum_->name](const SignedIn& by) { return PublishedCurricula(by).draft(name); },
      [this, round = round_](const Result<std::string>& theirs) {
        if (round != round_) return;
        kept_ = sent_ = theirs ? *theirs : std::string();
        contested_ = false;
        save();
        Q_EMIT savingChanged();
      });
}

void CurriculumController::begin(const QString& name, std::function<void(Result<void>)> done) {
  save();
  account_->query<KeptDraft>(
      this, [name = name.trimmed().toStdString()](const SignedIn& by) { return newDraft(by, name); },
      [this, done = std::move(done)](const Result<KeptDraft>& draft) {
        done(draft ? Result<void>() : fail(draft.error().message));
        if (draft) takeDraft(draft);
      });
}

void CurriculumController::beginVersion() {
  if (!chosen_) return;
  account_->query<KeptDraft>(
      this, [offer = *chosen_](const SignedIn& by) { return draftFrom(by, offer); },
      [this](const Result<KeptDraft>& draft) { takeDraft(draft); });
}

void CurriculumController::discard() {
  if (!isDraft()) return;
  soon_.stop();
  account_->query<void>(
      this,
      [name = curriculum_->name, before = sent_](const SignedIn& by) {
        return PublishedCurricula(by).discardDraft(name, before);
      },
      [this](const Result<void>& done) {
        if (!done) return Q_EMIT statusMessage(QString::fromStdString(done.error().message), true);
        chosen_.reset(), curriculum_.reset(), saved_ = true;
        Q_EMIT curriculumChanged();
        Q_EMIT savingChanged();
        Q_EMIT statusMessage(tr("The draft was discarded. Published versions are unchanged."), false);
        refresh();
      });
}

void CurriculumController::publish(std::function<void(Result<void>)> done) {
  if (!isDraft()) return;
  soon_.stop();
  account_->query<void>(
      this, [draft = *curriculum_, before = sent_](const SignedIn& by) { return publishDraft(by, draft, before); },
      [this, done = std::move(done),
       now = OfferedCurriculum{curriculum_->name, curriculum_->version, Kind::Published}](const Result<void>& outcome) {
        done(outcome);
        if (!outcome) return handleRefusal(outcome.error().message);
        saved_ = true;
        choose(now);
        refresh();
        Q_EMIT statusMessage(tr("The version is published. To assign this version to a class, choose the class in the "
                                "line Class and press Assign version to class."),
                             false);
      });
}

void CurriculumController::teach(const std::string& cohort) {
  if (!chosen_ || isDraft()) return;
  account_->query<void>(
      this, [offer = *chosen_, cohort](const SignedIn& by) { return teachBy(by, offer, cohort); },
      [this](const Result<void>& done) {
        Q_EMIT statusMessage(
            done ? tr("The class uses this version from now on.") : QString::fromStdString(done.error().message),
            !done);
        refresh();
      });
}

}  // namespace insonate::ui
