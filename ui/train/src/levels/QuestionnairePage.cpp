#include "QuestionnairePage.h"

#include <insonate/curriculum/FormStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/FormSheet.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kWidest_px = 900, kDraft_ms = 500;

/// It comes with the program.
Form questionnaire() {
  for (const std::string& name : formPresetNames())
    if (auto form = loadForm(name); form && form->purpose == Form::Purpose::Questionnaire) return std::move(*form);
  return {};
}

}  // namespace

QuestionnairePage::QuestionnairePage(ui::Account* account, QString draftFolder, QWidget* parent)
    : QWidget(parent),
      account_(account),
      draft_(std::make_shared<ui::FormDraft>(std::move(draftFolder))),
      words_(new QLabel),
      sheet_(new ui::FormSheet(questionnaire())),
      scroll_(new QScrollArea),
      send_(ui::pushButton("formSend", tr("Send"), tr("Stores the answers; they cannot be changed afterwards"))),
      clear_(ui::pushButton("formClear", tr("Clear"), tr("Clears all answers"))) {
  ui::setRole(send_, "primary");
  words_->setObjectName(QStringLiteral("formWords"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  sheet_->setMaximumWidth(kWidest_px);
  scroll_->setWidget(sheet_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* row = new QHBoxLayout;
  row->addWidget(send_);
  row->addWidget(clear_);
  row->addStretch(1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(words_);
  box->addWidget(scroll_, 1);
  box->addLayout(row);
  keeping_.setSingleShot(true);
  keeping_.setInterval(kDraft_ms);
  connect(&keeping_, &QTimer::timeout, this, [this] { keepDraft(); });
  connect(sheet_, &ui::FormSheet::changed, &keeping_, qOverload<>(&QTimer::start));
  connect(send_, &QPushButton::clicked, this, [this] { send(); });
  connect(clear_, &QPushButton::clicked, this, [this] { clear(); });
  if (account_) connect(account_, &ui::Account::changed, this, [this] { changePerson(); });
  changePerson();
}

QuestionnairePage::~QuestionnairePage() {
  if (keeping_.isActive()) keepDraft();
}

void QuestionnairePage::changePerson() {
  if (keeping_.isActive()) keepDraft();
  const bool somebody = account_ && account_->isSignedIn() && !account_->mustChangePassword();
  person_ = somebody ? account_->person().id : std::string();
  const FormAnswers kept = somebody ? draft_->read({person_}, sheet_->form()) : FormAnswers{};
  sheet_->setAnswers(kept);
  words_->setText(!somebody ? tr("Sign in (Ctrl+L) to answer the questionnaire; your answers are kept with your name.")
                  : kept.empty() ? QString::fromStdString(sheet_->form().about)
                                 : tr("These are your answers so far. They are not sent yet."));
  for (QWidget* one : {static_cast<QWidget*>(scroll_), static_cast<QWidget*>(send_), static_cast<QWidget*>(clear_)})
    one->setVisible(somebody);
}

void QuestionnairePage::keepDraft() {
  keeping_.stop();
  if (!person_.empty()) draft_->save({person_}, sheet_->form(), sheet_->answers());
}

void QuestionnairePage::clear() {
  sheet_->setAnswers({});
  keepDraft();
}

void QuestionnairePage::send() {
  if (!sheet_->check())
    return Q_EMIT messageReported(tr("Some answers cannot be stored; the errors are stated beside them."));
  const FormAnswers answers = sheet_->answers();
  if (answers.empty()) return Q_EMIT messageReported(tr("Nothing is answered yet."));
  keepDraft();
  FilledForm filled;
  filled.form = sheet_->form().name, filled.formVersion = sheet_->form().version;
  filled.person = filled.by = person_;
  filled.answers = answersText(answers);
  filled = sending_.identified(std::move(filled));
  send_->setEnabled(false);
  account_->query<std::string>(
      this,
      [filled, draft = draft_, form = sheet_->form()](const SignedIn& by) {
        auto id = FormStore(by).add(filled);
        // Here, since who has signed out by then hears nothing of it.
        if (id) draft->save({filled.person}, form, {});
        return id;
      },
      [this, person = person_](const Result<std::string>& id) {
        send_->setEnabled(true);
        if (id) sending_.stored();
        if (person == person_) sent(id ? QString() : QString::fromStdString(id.error().message));
      });
}

void QuestionnairePage::sent(const QString& error) {
  words_->setText(error.isEmpty() ? tr("Thank you. Your answers are stored.")
                                  : tr("%1 Your answers are kept on this computer; send them again later.").arg(error));
  Q_EMIT messageReported(words_->text());
  if (error.isEmpty()) clear();
}

}  // namespace insonate::train
