/* A command of ours, run by a server that has Python and our modules loaded already (warm.py).

   It hands over its arguments, folder, environment and standard streams, and ends as the command ends. Where a stream
   is closed, or Python itself is told how to start by the environment, the command is started as it is. */

#include <fcntl.h>
#include <libgen.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

enum { LONGEST = 1 << 20, STREAMS = 3 };

extern char **environ;

static char message[LONGEST];
static size_t length = sizeof(int);

static void add(const char *text)
{
    size_t size = strlen(text) + 1;
    if (length + size > sizeof message) exit(127);
    memcpy(message + length, text, size);
    length += size;
}

static int plain(void)
{
    char **one;
    int stream;
    for (one = environ; *one; one++)
        if (strncmp(*one, "PYTHONIOENCODING=", 17) == 0 || strncmp(*one, "PYTHONHASHSEED=", 15) == 0) return 0;
    for (stream = 0; stream < STREAMS; stream++)
        if (fcntl(stream, F_GETFD) < 0) return 0;
    return 1;
}

static void cold(char **argv)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", getenv("COLD_COMMANDS"), basename(argv[0]));
    execv(path, argv);
    perror(path);
    exit(127);
}

static int server(void)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    int to = socket(AF_UNIX, SOCK_STREAM, 0);
    snprintf(address.sun_path, sizeof address.sun_path, "%s", getenv("WARM_COMMANDS"));
    return connect(to, (struct sockaddr *)&address, sizeof address) == 0 ? to : -1;
}

static int hand_over(int to)
{
    union {
        char buffer[CMSG_SPACE(STREAMS * sizeof(int))];
        struct cmsghdr align;
    } control;
    struct iovec body = {message, sizeof(int)};
    struct msghdr header = {.msg_iov = &body, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
    struct cmsghdr *streams = CMSG_FIRSTHDR(&header);
    size_t sent = sizeof(int);
    streams->cmsg_level = SOL_SOCKET;
    streams->cmsg_type = SCM_RIGHTS;
    streams->cmsg_len = CMSG_LEN(STREAMS * sizeof(int));
    memcpy(CMSG_DATA(streams), (int[]){0, 1, 2}, STREAMS * sizeof(int));
    *(int *)message = (int)(length - sizeof(int));
    if (sendmsg(to, &header, 0) != (ssize_t)sizeof(int)) return 0;
    while (sent < length) {
        ssize_t count = write(to, message + sent, length - sent);
        if (count <= 0) return 0;
        sent += (size_t)count;
    }
    return 1;
}

int main(int argc, char **argv)
{
    char folder[4096], count[16];
    char **one;
    int to, status;
    if (!getenv("WARM_COMMANDS") || !plain() || (to = server()) < 0) cold(argv);
    snprintf(count, sizeof count, "%d", argc);
    add(getcwd(folder, sizeof folder) ? folder : "/");
    add(count);
    add(basename(argv[0]));
    for (one = argv + 1; *one; one++) add(*one);
    for (one = environ; *one; one++) add(*one);
    if (!hand_over(to)) return 127;
    for (status = 0; status < STREAMS; status++) close(status);
    if (read(to, &status, sizeof status) != sizeof status) return 127;
    if (WIFSIGNALED(status)) {
        signal(WTERMSIG(status), SIG_DFL);
        kill(getpid(), WTERMSIG(status));
    }
    return WEXITSTATUS(status);
}
