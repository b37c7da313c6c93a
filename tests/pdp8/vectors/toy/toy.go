package toy

type Toy struct {
	pc, ac, link int
	core         [4096]int
}

func (t *Toy) step() {
	word := t.core[t.pc]
	address := word & 0177
	if word&0200 != 0 {
		address |= t.pc & 07600
	}
	if word&0400 != 0 {
		if address>>3 == 1 {
			t.core[address] = (t.core[address] + 1) & 07777
		}
		address = t.core[address]
	}
	total := (t.link<<12 | t.ac) + t.core[address]
	t.pc, t.ac, t.link = (t.pc+1)&07777, total&07777, total>>12&1
}
