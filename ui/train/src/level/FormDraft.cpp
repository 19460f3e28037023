#include "FormDraft.h"

#include <insonate/core/AtomicFile.h>

#include <QDir>
#include <QFile>
#include <QUuid>
#include <utility>

namespace insonate::train {
namespace {

constexpr qint64 kMost_bytes = 1 << 20;

}  // namespace

FormDraft::FormDraft(QString folder) : folder_(std::move(folder)) {
  writer_.setMaxThreadCount(1);
}

FormDraft::~FormDraft() {
  writer_.waitForDone();
}

QString FormDraft::fileOf(const std::string& person, const Form& form) const {
  return QDir(folder_).filePath(
      QStringLiteral("%1-%2-%3.json")
          .arg(QUuid(QString::fromStdString(person)).toString(QUuid::WithoutBraces), QString::fromStdString(form.name))
          .arg(form.version));
}

FormAnswers FormDraft::read(const std::string& person, const Form& form) const {
  QFile file(fileOf(person, form));
  if (file.size() > kMost_bytes || !file.open(QIODevice::ReadOnly)) return {};
  return parseAnswers(file.readAll().toStdString()).value_or(FormAnswers{});
}

void FormDraft::keep(const std::string& person, const Form& form, const FormAnswers& answers) {
  writer_.start([folder = folder_, file = fileOf(person, form), text = answersText(answers), none = answers.empty()] {
    if (none)
      QFile::remove(file);
    else if (QDir().mkpath(folder))
      (void)writeAtomically(file.toStdString(), text);
  });
}

}  // namespace insonate::train
