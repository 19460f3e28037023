#include <insonate/core/AtomicFile.h>
#include <insonate/ui/FormDraft.h>

#include <QDir>
#include <QFile>
#include <QUuid>
#include <utility>

namespace insonate::ui {
namespace {

constexpr qint64 kMost_bytes = 1 << 20;

}  // namespace

FormDraft::FormDraft(QString folder) : folder_(std::move(folder)) {
  writer_.setMaxThreadCount(1);
}

FormDraft::~FormDraft() {
  writer_.waitForDone();
}

QString FormDraft::fileOf(const FormSubject& subject, const Form& form) const {
  const auto plain = [](const std::string& id) {
    return QUuid(QString::fromStdString(id)).toString(QUuid::WithoutBraces);
  };
  const QString about = subject.attempt.empty() ? QString() : plain(subject.attempt) + QLatin1Char('-');
  return QDir(folder_).filePath(QStringLiteral("%1-%2%3-%4.json")
                                    .arg(plain(subject.by), about, QString::fromStdString(form.name))
                                    .arg(form.version));
}

FormAnswers FormDraft::read(const FormSubject& subject, const Form& form) const {
  QFile file(fileOf(subject, form));
  if (file.size() > kMost_bytes || !file.open(QIODevice::ReadOnly)) return {};
  return parseAnswers(file.readAll().toStdString()).value_or(FormAnswers{});
}

void FormDraft::save(const FormSubject& subject, const Form& form, const FormAnswers& answers) {
  writer_.start([folder = folder_, file = fileOf(subject, form), text = answersText(answers), none = answers.empty()] {
    if (none)
      QFile::remove(file);
    else if (QDir().mkpath(folder))
      (void)writeAtomically(file.toStdString(), text);
  });
}

}  // namespace insonate::ui
