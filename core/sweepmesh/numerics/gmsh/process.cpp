#include "sweepmesh/numerics/gmsh/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace sweepmesh {
namespace {

constexpr int cannot_start = 127;  // as a shell says it
constexpr auto first_pause = std::chrono::milliseconds(1);
constexpr auto longest_pause = std::chrono::milliseconds(20);

/// Only calls that are safe between fork and exec in a program with threads.
[[noreturn]] void become(char* const* arguments, char* const* environment, const char* directory,
                         const char* program) {
  if (chdir(directory) != 0) _exit(cannot_start);
  const int log = open("log.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int nothing = open("/dev/null", O_RDONLY);
  if (log < 0 || nothing < 0) _exit(cannot_start);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execve(program, arguments, environment);
  _exit(cannot_start);
}

std::string found_on_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* variable = std::getenv("PATH");
  const std::string path = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    const std::string candidate = path.substr(begin, end - begin) + "/" + program;
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
    begin = end + 1;
  }
  return {};
}

std::vector<std::string> environment_with_home(const std::string& home) {
  std::vector<std::string> out;
  for (char** entry = environ; *entry; ++entry)
    if (std::string(*entry).rfind("HOME=", 0) != 0) out.emplace_back(*entry);
  out.push_back("HOME=" + home);
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& s : strings) out.push_back(s.data());
  out.push_back(nullptr);
  return out;
}

int wait_for(pid_t child, const Context& context) {
  auto pause = first_pause;
  for (int status = 0;;) {
    if (waitpid(child, &status, WNOHANG) == child)
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (context.is_cancelled()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      context.check("surface");
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(longest_pause));
  }
}

}  // namespace

TemporaryDirectory::TemporaryDirectory() {
  std::error_code error;
  const auto parent = std::filesystem::temp_directory_path(error);
  std::string name = (error ? std::filesystem::path("/tmp") : parent) / "sweepmesh-XXXXXX";
  if (!mkdtemp(name.data()))
    throw SolverError("surface", "No temporary directory could be made in " +
                                     std::filesystem::path(name).parent_path().string() + ".");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

int run_process(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                const Context& context) {
  const std::string program = found_on_path(arguments.at(0));
  const SolverError missing("surface", "The program " + arguments[0] + " could not be started.");
  if (program.empty()) throw missing;
  std::vector<std::string> words = arguments;
  std::vector<std::string> variables = environment_with_home(directory.string());
  const std::vector<char*> argument_pointers = pointers(words);
  const std::vector<char*> variable_pointers = pointers(variables);
  const pid_t child = fork();
  if (child < 0) throw missing;
  if (child == 0)
    become(argument_pointers.data(), variable_pointers.data(), directory.c_str(), program.c_str());
  const int status = wait_for(child, context);
  if (status == cannot_start) throw missing;
  return status;
}

}  // namespace sweepmesh
