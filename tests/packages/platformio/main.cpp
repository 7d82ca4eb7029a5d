// Runs a sketch: setup, and loop twice.
#include "Arduino.h"

Port Serial;

unsigned long micros() {return 0;}
void delay(unsigned long) {}

int main()
{
  setup();
  loop();
  loop();
  return 0;
}
