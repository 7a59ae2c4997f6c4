// The program `swaplight`: one verb a job.
#include "app/program.h"

int main(int argc, char** argv) {
  swaplight::Program program;
  return program.run(argc, argv);
}
