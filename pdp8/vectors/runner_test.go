// Play vectors on an emulator in Go. Copy this file into the emulator's folder, make the package below its
// package, and write newEmulator in a file of your own, named ..._test.go, in the same package. Then
//
//	go test -run TestVectors -v -vectors FOLDER [-model 8/E] [-files 'opr*']

package main

import (
	"bufio"
	"compress/gzip"
	"encoding/json"
	"flag"
	"fmt"
	"os"
	"path/filepath"
	"slices"
	"strings"
	"testing"
)

// Emulator is what newEmulator() returns.
type Emulator interface {
	// Set the registers pc, ac, link, sr, ion, mem_prot; flags down, RUN on, a FETCH comes next.
	Set(registers map[string]int)
	Deposit(address, word int)
	Examine(address int) int
	// Run so many instructions, and the interrupt that comes after the last.
	Run(instructions int)
	// Get the registers, and run, protect, ticks; what is left out is not compared.
	Get() map[string]int
}

// Flagger is an Emulator whose devices have flags. Flag raises one, and returns whether there is such a device; if
// not, the vector is passed over.
type Flagger interface{ Flag(device int) bool }

// Cycler is an Emulator that can run one memory cycle; Cycle is called in place of Run.
type Cycler interface {
	Cycle() (state string, ma, mb int)
}

type vector struct {
	Name         string
	Models       []string
	Instructions int
	Initial      state
	Final        state
	Ticks        int
	Cycles       [][3]any
}

type state struct {
	PC, AC, Link, SR, Ion int
	MemProt               *int `json:"mem_prot"`
	Run, Protect          *int
	RAM                   [][2]int
	Flags                 []int
}

// shown is the number of words of which a difference is printed, of each file.
const shown = 20

var (
	folder = flag.String("vectors", ".", "the folder of the vectors")
	model  = flag.String("model", "8/L", "play the vectors that hold for this model: 8, 8/S, 8/I, 8/L, 8/E")
	files  = flag.String("files", "*", "play the files of these names")
)

func TestVectors(t *testing.T) {
	names, err := filepath.Glob(filepath.Join(*folder, *files+".json.gz"))
	if err != nil || len(names) == 0 {
		t.Fatalf("%s: no vectors there: -vectors FOLDER says where they are", filepath.Join(*folder, *files))
	}
	var emulator Emulator = newEmulator()
	all := 0
	for _, name := range names {
		t.Run(filepath.Base(name), func(t *testing.T) { all += playFile(t, name, emulator) })
	}
	if all == 0 {
		t.Fatalf("no vector holds for the model %q", *model)
	}
}

// playFile returns how many vectors were played.
func playFile(t *testing.T, name string, emulator Emulator) int {
	file, err := os.Open(name)
	if err != nil {
		t.Fatal(err)
	}
	defer file.Close()
	unpacked, err := gzip.NewReader(file)
	if err != nil {
		t.Fatal(err)
	}
	played, different, words := 0, 0, map[string]bool{}
	for lines := bufio.NewScanner(unpacked); lines.Scan(); {
		line := strings.TrimSuffix(lines.Text(), ",")
		if !strings.HasPrefix(line, "{") {
			continue
		}
		var v vector
		if err := json.Unmarshal([]byte(line), &v); err != nil {
			t.Fatal(err)
		}
		if v.Cycles == nil || !slices.Contains(v.Models, *model) {
			continue
		}
		found, ok := v.play(emulator)
		if !ok {
			continue
		}
		played++
		if found != "" {
			different++
			if word := strings.Fields(v.Name)[0]; !words[word] {
				words[word] = true
				if len(words) <= shown {
					t.Errorf("%s: %s", v.Name, found)
				}
			}
		}
	}
	t.Logf("%d played, %d differ in %d words", played, different, len(words))
	return played
}

// play returns the first difference, or "", and whether the emulator can do the vector.
func (v vector) play(emulator Emulator) (string, bool) {
	initial := v.Initial.registers()
	initial["mem_prot"] += 0 // there is one, also where the switch is not named
	emulator.Set(initial)
	for _, one := range v.Initial.RAM {
		emulator.Deposit(one[0], one[1])
	}
	for _, device := range v.Initial.Flags {
		if flagger, ok := emulator.(Flagger); !ok || !flagger.Flag(device) {
			return "", false
		}
	}
	if cycler, ok := emulator.(Cycler); ok {
		for number, meant := range v.Cycles {
			state, ma, mb := cycler.Cycle()
			for i, got := range [3]any{state, float64(ma), float64(mb)} {
				if got != meant[i] {
					what := [3]string{"state", "MA", "MB"}[i]
					return fmt.Sprintf("%s of cycle %d is %s, not %s", what, number+1, octal(got), octal(meant[i])), true
				}
			}
		}
	} else {
		emulator.Run(v.Instructions)
	}
	return v.Final.difference(emulator, v.Ticks), true
}

func (s state) difference(emulator Emulator, meantTicks int) string {
	got, final := emulator.Get(), s.registers()
	if ticks, ok := got["ticks"]; ok && ticks != meantTicks {
		return fmt.Sprintf("ticks is %d, not %d", ticks, meantTicks)
	}
	for _, name := range []string{"pc", "ac", "link", "sr", "ion", "mem_prot", "run", "protect"} {
		value, has := got[name]
		if meant, ok := final[name]; ok && has && value != meant {
			return fmt.Sprintf("%s is %o, not %o", name, value, meant)
		}
	}
	for _, one := range s.RAM {
		if word := emulator.Examine(one[0]); word != one[1] {
			return fmt.Sprintf("core %o is %o, not %o", one[0], word, one[1])
		}
	}
	return ""
}

func octal(value any) string {
	if number, ok := value.(float64); ok {
		return fmt.Sprintf("%o", int(number))
	}
	return fmt.Sprint(value)
}

func (s state) registers() map[string]int {
	all := map[string]int{"pc": s.PC, "ac": s.AC, "link": s.Link, "sr": s.SR, "ion": s.Ion}
	for name, value := range map[string]*int{"mem_prot": s.MemProt, "run": s.Run, "protect": s.Protect} {
		if value != nil {
			all[name] = *value
		}
	}
	return all
}
