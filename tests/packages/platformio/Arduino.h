// In place of a board's core: what the sketch uses of it, on the machine that runs the tests.
#pragma once

#include <cstdio>

void setup();
void loop();
unsigned long micros();
void delay(unsigned long milliseconds);

struct Port
{
  void begin(unsigned long) {}
  void print(const char * text) {std::fputs(text, stdout);}
  void print(unsigned long number) {std::printf("%lu", number);}
  void println(const char * text) {std::puts(text);}
};

extern Port Serial;
