#include <insonate/gpu/Program.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>

namespace insonate::gpu {
namespace {

std::string logOf(unsigned id, bool shader) {
  int length = 0;
  (shader ? glGetShaderiv : glGetProgramiv)(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::max(length, 1), '\0');
  (shader ? glGetShaderInfoLog : glGetProgramInfoLog)(id, length, &length, log.data());
  log.resize(std::max(length, 0));
  while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
  return log;
}

struct Member {
  std::string name;
  std::size_t offset;
};

/// Fields of a uniform block as the driver laid them out. Of an array of structures, only the first element is kept,
/// since the others repeat it.
std::vector<Member> membersOf(unsigned program, unsigned block) {
  const unsigned countOf = GL_NUM_ACTIVE_VARIABLES, listOf = GL_ACTIVE_VARIABLES;
  int count = 0;
  glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, block, 1, &countOf, 1, nullptr, &count);
  std::vector<int> indices(count);
  glGetProgramResourceiv(program, GL_UNIFORM_BLOCK, block, 1, &listOf, count, nullptr, indices.data());
  std::vector<Member> members;
  for (const int index : indices) {
    std::string name(256, '\0');
    int length = 0, offset = 0;
    const unsigned property = GL_OFFSET;
    glGetProgramResourceName(program, GL_UNIFORM, index, int(name.size()), &length, name.data());
    glGetProgramResourceiv(program, GL_UNIFORM, index, 1, &property, 1, nullptr, &offset);
    name.resize(length);
    const auto bracket = name.find('[');
    const bool later = bracket != std::string::npos && name.compare(bracket, 3, "[0]") != 0;
    if (!later) members.push_back({std::move(name), std::size_t(offset)});
  }
  return members;
}

}  // namespace

Program::Program(std::shared_ptr<Context> context, std::string name, unsigned id)
    : context_(std::move(context)), name_(std::move(name)), id_(id) {}

Program::Program(Program&& other) noexcept
    : context_(std::move(other.context_)), name_(std::move(other.name_)), id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(context_, other.context_), std::swap(name_, other.name_), std::swap(id_, other.id_);
  return *this;
}

Program::~Program() {
  if (id_ == 0) return;
  if (const auto current = context_->use()) glDeleteProgram(id_);
}

Result<Program> Program::make(const CurrentContext& current, std::string name,
                              std::span<const std::string_view> parts) {
  std::vector<const char*> texts{"#version 430 core\n"};
  std::vector<int> lengths{-1};
  for (const std::string_view part : parts) texts.push_back(part.data()), lengths.push_back(int(part.size()));

  const unsigned shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, int(texts.size()), texts.data(), lengths.data());
  glCompileShader(shader);
  int ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    const std::string log = logOf(shader, true);
    glDeleteShader(shader);
    return fail("The shader \"" + name + "\" does not compile: " + log);
  }
  Program program(current.context(), std::move(name), glCreateProgram());
  glAttachShader(program.id_, shader);
  glLinkProgram(program.id_);
  glDeleteShader(shader);
  glGetProgramiv(program.id_, GL_LINK_STATUS, &ok);
  if (!ok) return fail("The shader \"" + program.name_ + "\" does not link: " + logOf(program.id_, false));
  return program;
}

Result<void> Program::checkBlock(const CurrentContext&, std::string_view block, std::span<const Field> fields,
                                 std::size_t size) const {
  const unsigned index = glGetProgramResourceIndex(id_, GL_UNIFORM_BLOCK, std::string(block).c_str());
  if (index == GL_INVALID_INDEX) return {};
  const std::string where =
      "The shader \"" + name_ + "\" and the program define this differently: " + std::string(block);
  const std::vector<Member> members = membersOf(id_, index);
  for (const Member& member : members) {
    const auto mirror = std::ranges::find(fields, member.name, &Field::name);
    if (mirror == fields.end()) return fail(where + ": only the shader has " + member.name + ".");
    if (mirror->offset != member.offset)
      return fail(where + ": " + member.name + " lies at byte " + std::to_string(member.offset) +
                  " in the shader and at " + std::to_string(mirror->offset) + " in the program.");
  }
  for (const Field& field : fields)
    if (std::ranges::find(members, field.name, &Member::name) == members.end())
      return fail(where + ": the shader lacks " + std::string(field.name) + ".");
  int bytes = 0;
  const unsigned property = GL_BUFFER_DATA_SIZE;
  glGetProgramResourceiv(id_, GL_UNIFORM_BLOCK, index, 1, &property, 1, nullptr, &bytes);
  if (std::size_t(bytes) != size)
    return fail(where + ": it has " + std::to_string(bytes) + " bytes in the shader and " + std::to_string(size) +
                " in the program.");
  return {};
}

void Program::setInt(const CurrentContext&, std::string_view uniform, int value) const {
  glProgramUniform1i(id_, glGetUniformLocation(id_, std::string(uniform).c_str()), value);
}

void Program::run(const CurrentContext&, int groupsX, int groupsY, int groupsZ) const {
  glUseProgram(id_);
  glDispatchCompute(groupsX, groupsY, groupsZ);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace insonate::gpu
