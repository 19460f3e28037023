#include "VtkRun.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <string>

namespace insonate {
namespace {

/// Receives a filter's progress, warnings and errors. VTK does not print messages that have an observer.
class Listener : public vtkCommand {
 public:
  static Listener* New() { return new Listener; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override {
    if (event == vtkCommand::ProgressEvent) {
      const double fraction = from + (to - from) * *static_cast<double*>(data);
      if (!cancelled && !report(progress, doing, fraction)) cancelled = true;
      if (auto* filter = vtkAlgorithm::SafeDownCast(caller); filter && cancelled) filter->SetAbortExecute(1);
    } else if (complaint.empty()) {
      complaint = static_cast<const char*>(data);
    }
  }

  Progress progress;
  std::string_view doing;
  double from = 0, to = 1;
  bool cancelled = false;
  std::string complaint;
};

}  // namespace

Result<void> runFilter(vtkAlgorithm& filter, const Progress& progress, std::string_view doing, double from, double to) {
  vtkNew<Listener> listener;
  listener->progress = progress;
  listener->doing = doing;
  listener->from = from;
  listener->to = to;
  filter.AddObserver(vtkCommand::ProgressEvent, listener);
  for (vtkObject* speaker : {static_cast<vtkObject*>(&filter), static_cast<vtkObject*>(filter.GetExecutive())})
    for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) speaker->AddObserver(event, listener);
  filter.Update();
  if (listener->cancelled || !report(progress, doing, to)) return fail(std::string(kCancelled));
  if (!listener->complaint.empty()) return fail("The surface could not be computed: " + listener->complaint);
  return {};
}

}  // namespace insonate
