/* Receiving BATTERY_STATUS with mavgen's C headers: mavlink_parse_char for each byte, then decode.
 *
 * Arguments: file with the frames, passes, rounds per pass.
 */
#include <common/mavlink.h>

#include "stopwatch.h"

static uint8_t data[65536];
static size_t size;
static mavlink_battery_status_t battery;

static void received(int count, int is_shown)
{
    mavlink_message_t message;
    mavlink_status_t status;
    const char *separator = "";
    for (int turn = 0; turn < count; turn++) {
        for (size_t index = 0; index < size; index++) {
            if (mavlink_parse_char(MAVLINK_COMM_0, data[index], &message, &status)) {
                mavlink_msg_battery_status_decode(&message, &battery);
                everything_counts();
                if (is_shown) {
                    printf("%s[%d, %d, %d, %d, %d, %d]", separator, battery.current_consumed, battery.energy_consumed,
                           battery.temperature, battery.voltages[0], battery.current_battery,
                           battery.battery_remaining);
                    separator = ", ";
                }
            }
        }
    }
}

int main(int argument_count, char **arguments)
{
    FILE *file = argument_count == 4 ? fopen(arguments[1], "rb") : NULL;
    if (file == NULL) {
        return 2;
    }
    size = fread(data, 1, sizeof(data), file);
    fclose(file);
    int passes = atoi(arguments[2]);
    int count = atoi(arguments[3]);
    printf("{\"shown\": [");
    received(1, 1);
    double fastest = 1e18;
    for (int pass = 0; pass < passes; pass++) {
        double start = now_ns();
        received(count, 0);
        double took = now_ns() - start;
        if (took < fastest) {
            fastest = took;
        }
    }
    printf("], \"ns\": %.3f}\n", fastest / count);
    return 0;
}
