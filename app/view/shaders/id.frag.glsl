flat in uint id;
out uint seen;

void main() { seen = id; }
