// The program that worker.h starts: reads directories, line by line, and meshes "cap.geo" to
// "cap.msh" in each of them, in a copy of itself; writes the copy's exit status, line by line.
#include <gmsh.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <string>

namespace {

/// False at the end of the input.
bool read_line(std::string& line) {
  line.clear();
  for (char letter = 0; read(STDIN_FILENO, &letter, 1) == 1; line += letter)
    if (letter == '\n') return true;
  return false;
}

int mesh(const std::string& directory) {
  if (chdir(directory.c_str()) != 0) return EXIT_FAILURE;
  try {
    gmsh::open("cap.geo");
    gmsh::model::mesh::generate(2);
    gmsh::option::setNumber("Mesh.MshFileVersion", 2.2);
    gmsh::write("cap.msh");
    return EXIT_SUCCESS;
  } catch (const std::exception&) {
    return EXIT_FAILURE;
  }
}

int mesh_in_copy(const std::string& directory) {
  const pid_t copy = fork();
  if (copy < 0) return EXIT_FAILURE;
  if (copy == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    _exit(mesh(directory));
  }
  int status = 0;
  waitpid(copy, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

int main() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  std::string line;
  while (read_line(line)) {
    const std::string answer = std::to_string(mesh_in_copy(line)) + "\n";
    if (write(STDIN_FILENO, answer.data(), answer.size()) < 0) break;
  }
  return EXIT_SUCCESS;
}
