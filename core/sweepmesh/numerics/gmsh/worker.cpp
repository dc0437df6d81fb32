#include "sweepmesh/numerics/gmsh/worker.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <utility>

namespace sweepmesh {
namespace {

constexpr int pause_milliseconds = 20;  // between looks at the cancel flag

SolverError cannot_start(const std::string& program) {
  return SolverError("surface", "The program " + program + " could not be started.");
}

/// What a started process gets: one end of the socket as its input, silence, and a group of its
/// own, so that its copies end with it and Ctrl-C is the caller's.
class Attributes {
 public:
  explicit Attributes(int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, socket, STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions_, output, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~Attributes() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  /// Empty when it cannot be started.
  int spawn(const std::string& program) {
    std::string name = program;
    char* const arguments[] = {name.data(), nullptr};
    pid_t process = -1;
    const int failed =
        posix_spawn(&process, program.c_str(), &actions_, &attributes_, arguments, environ);
    return failed ? -1 : process;
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

std::string GmshWorker::default_program() {
  Dl_info module{};
  if (dladdr(reinterpret_cast<void*>(&GmshWorker::default_program), &module) != 0) {
    const auto beside =
        std::filesystem::path(module.dli_fname).parent_path() / "sweepmesh_gmsh_worker";
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored)) return beside.string();
  }
  return SWEEPMESH_GMSH_WORKER;
}

GmshWorker::GmshWorker(const std::string& program) : program_(program) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw cannot_start(program);
  socket_ = ends[0];
  process_ = Attributes(ends[1]).spawn(program);
  close(ends[1]);
  if (process_ >= 0) return;
  close(socket_);
  throw cannot_start(program);
}

GmshWorker::~GmshWorker() {
  close(socket_);
  kill(-process_, SIGKILL);
  int status = 0;
  waitpid(process_, &status, 0);
}

int GmshWorker::run(const std::filesystem::path& directory, const Context& context) {
  send(directory.string() + "\n");
  std::string answer;
  while (answer.empty() || answer.back() != '\n') {
    while (!can_read()) context.check("surface");
    char letter = 0;
    if (recv(socket_, &letter, 1, 0) != 1) throw cannot_start(program_);
    answer += letter;
  }
  return std::atoi(answer.c_str());
}

void GmshWorker::send(const std::string& line) const {
  const auto n = static_cast<ssize_t>(line.size());
  if (::send(socket_, line.data(), line.size(), MSG_NOSIGNAL) != n) throw cannot_start(program_);
}

bool GmshWorker::can_read() const {
  pollfd one{socket_, POLLIN, 0};
  return poll(&one, 1, pause_milliseconds) > 0;
}

std::unique_ptr<GmshWorker> GmshWorkers::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto worker = std::move(idle_.back());
      idle_.pop_back();
      return worker;
    }
  }
  return std::make_unique<GmshWorker>();
}

void GmshWorkers::give_back(std::unique_ptr<GmshWorker> worker) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(worker));
}

}  // namespace sweepmesh
