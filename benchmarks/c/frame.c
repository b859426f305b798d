/* Values to frame with mavgen's C headers: mavlink_msg_battery_status_pack, then mavlink_msg_to_send_buffer.
 *
 * Arguments: passes, frames per pass, and what the frame has, see frame.py.
 */
#include <common/mavlink.h>

#include "stopwatch.h"

static int values[10];
static uint16_t voltages[10];
static uint16_t more_voltages[4];
static uint8_t buffer[MAVLINK_MAX_PACKET_LEN];

static unsigned frames(int first, int count)
{
    mavlink_message_t message;
    unsigned length = 0;
    for (int consumed = first; consumed < first + count; consumed++) {
        mavlink_msg_battery_status_pack(values[0], values[1], &message, values[2], values[3], values[4], values[5],
                                        voltages, values[7], consumed, values[8], values[9], 0, 0, more_voltages, 0, 0);
        length = mavlink_msg_to_send_buffer(buffer, &message);
        everything_counts();
    }
    return length;
}

static void print_frame(int first)
{
    mavlink_get_channel_status(MAVLINK_COMM_0)->current_tx_seq = 0;
    unsigned length = frames(first, 1);
    for (unsigned index = 0; index < length; index++) {
        printf("%02x", buffer[index]);
    }
}

int main(int argument_count, char **arguments)
{
    if (argument_count != 13) {
        return 2;
    }
    int passes = atoi(arguments[1]);
    int count = atoi(arguments[2]);
    for (int index = 0; index < 10; index++) {
        values[index] = atoi(arguments[3 + index]);
        voltages[index] = UINT16_MAX;
    }
    voltages[0] = values[6];
    printf("{\"shown\": [\"");
    print_frame(1234);
    printf("\", \"");
    print_frame(98765);
    double fastest = 1e18;
    for (int pass = 0; pass < passes; pass++) {
        double start = now_ns();
        frames(1, count);
        double took = now_ns() - start;
        if (took < fastest) {
            fastest = took;
        }
    }
    printf("\"], \"ns\": %.3f}\n", fastest / count);
    return 0;
}
