extern int pc, ac, l, core[4096];
void step(void);
