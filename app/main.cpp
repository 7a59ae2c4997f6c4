// The program `swaplight`: one verb a job.
int main() {
  return 0;
}
