// The reference as an emulator for the runner of the vectors in Go.
package main

// #include "emulator.h"
import "C"
import "os"

type reference struct{ registers C.struct_registers }

// cycling is the reference by memory cycles.
type cycling struct{ reference }

// newEmulator returns a *cycling where the environment has CYCLES.
func newEmulator() Emulator {
	if os.Getenv("CYCLES") != "" {
		return &cycling{}
	}
	return &reference{}
}

func (c *cycling) Cycle() (string, int, int) {
	var state C.char
	var ma, mb C.int
	C.emulator_cycle(&state, &ma, &mb)
	return map[C.char]string{'F': "FETCH", 'D': "DEFER", 'E': "EXECUTE"}[state], int(ma), int(mb)
}

func (r *reference) Set(registers map[string]int) {
	for name, register := range r.named() {
		*register = C.int(registers[name])
	}
	C.emulator_set(&r.registers)
}

// named returns where each register is.
func (r *reference) named() map[string]*C.int {
	all := &r.registers
	return map[string]*C.int{
		"pc": &all.pc, "ac": &all.ac, "link": &all.link, "sr": &all.sr, "ion": &all.ion,
		"mem_prot": &all.mem_prot, "run": &all.run, "protect": &all.protect, "ticks": &all.ticks,
	}
}

func (r *reference) Deposit(address, word int) { C.emulator_deposit(C.int(address), C.int(word)) }
func (r *reference) Examine(address int) int   { return int(C.emulator_examine(C.int(address))) }
func (r *reference) Flag(device int) bool      { return C.emulator_flag(C.int(device)) != 0 }
func (r *reference) Run(instructions int)      { C.emulator_run(C.int(instructions)) }

func (r *reference) Get() map[string]int {
	C.emulator_get(&r.registers)
	got := map[string]int{}
	for name, register := range r.named() {
		got[name] = int(*register)
	}
	return got
}
